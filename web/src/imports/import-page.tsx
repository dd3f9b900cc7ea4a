import '../look/imports.css';
import { may } from '../session/session';
import { AskFirst } from '../ui/ask-first';
import { addressOf } from '../ui/client';
import { FlawList } from '../ui/flaw-list';
import { MessageText } from '../ui/message-text';
import { messageOf } from '../ui/notice';
import { Press } from '../ui/press';
import { go } from '../ui/route';
import type { Screen } from '../ui/screen';
import { TextField } from '../ui/text-field';
import { Told } from '../ui/told';
import { moment } from '../ui/units';
import { Changes } from './changes';
import { FileChoice } from './file-choice';
import { Identified } from './identified';
import { importWords } from './import-words';
import {
  armAlone,
  diagnose,
  forget,
  identify,
  identifying,
  log,
  MOST_LETTERS,
  name,
  reading,
  refused,
  sending,
  sound,
  working,
} from './imports';
import { LogLook } from './log-look';
import { Question } from './question';
import { Understood } from './understood';

const mayImport = () => may('engineer', 'operator');

/** A log of another program: its files, what it was taken for, what has to be answered. */
function Import() {
  const said = importWords.value;
  if (!mayImport())
    return (
      <div class="page">
        <h1>{said.title}</h1>
        <p>{said.closed}</p>
      </div>
    );
  const found = log.value?.reading ?? null;
  return (
    <div class="page import">
      <h1>{said.title}</h1>
      <FileChoice />
      <div class="stack found">
        <Refused />
        {found?.question && <Question key={found.question.key} question={found.question} />}
        <Identified />
        <Checked />
        {found?.understood && (
          <>
            <Understood log={found.understood} />
            <Changes changes={found.changes} open={found.contradiction !== null} />
          </>
        )}
        {found?.preview && <LogLook preview={found.preview} />}
      </div>
      {log.value && (
        <div class="discard">
          <p class="hint">{said.expires(moment(log.value.expires_at))}</p>
          <AskFirst label={said.discard} question={said.discardAsk} yes={said.discardYes} act={forget} />
        </div>
      )}
    </div>
  );
}

function Refused() {
  const said = importWords.value;
  const shown = refused.value;
  if (shown === null) return null;
  if (shown.flaws.length > 0) return <FlawList title={said.refused} flaws={shown.flaws} />;
  return shown.notice ? (
    <div class="warnings" role="alert">
      <h2>
        <span aria-hidden="true">▲</span> {said.refused}
      </h2>
      <Told message={messageOf(shown.notice)} />
    </div>
  ) : null;
}

/** What the set-up checks found, and what may be done then. */
function Checked() {
  const said = importWords.value;
  const found = log.value?.reading;
  if (!found?.understood) return null;
  if (found.contradiction)
    return (
      <div class="warnings" role="alert">
        <h2>
          <span aria-hidden="true">▲</span> {said.contradicted}
        </h2>
        <Told message={found.contradiction} />
        <p>{said.contradictedHint}</p>
      </div>
    );
  return (
    <section class="stack">
      <p role="status" class="sentence">
        <span aria-hidden="true">✓</span> {said.sound}
      </p>
      {found.remarks.length > 0 && (
        <div>
          <h3>{said.remarks}</h3>
          <ul>
            {found.remarks.map((remark) => (
              <li key={remark.text}>
                <MessageText message={remark} />
              </li>
            ))}
          </ul>
        </div>
      )}
      <Downloads />
    </section>
  );
}

function Downloads() {
  const said = importWords.value;
  const path = { log_import: log.value?.log_import ?? '' };
  return (
    <>
      <TextField
        label={said.name}
        text={name.value}
        change={(text) => {
          name.value = text.slice(0, MOST_LETTERS);
        }}
      />
      <p class="downloads">
        <a class="download" href={addressOf('/api/imports/{log_import}/mapping', path)} download="map.toml">
          {said.mapping}
        </a>
        <a class="download" href={addressOf('/api/imports/{log_import}/recording', path)} download>
          {said.recording}
        </a>
      </p>
      <p class="hint">{said.downloadsHint}</p>
    </>
  );
}

function Actions() {
  const said = importWords.value;
  const identified = log.value?.identified != null;
  if (!mayImport()) return null;
  return (
    <>
      <Press act={() => go('gap')}>{said.back}</Press>
      <Press kind={identified ? 'primary' : 'plain'} disabled={!sound.value || working.value} act={finish}>
        {said.diagnose}
      </Press>
      {!identified && (
        <Press kind="primary" disabled={!sound.value || working.value} act={identify}>
          {said.identify}
        </Press>
      )}
    </>
  );
}

async function finish(): Promise<void> {
  const queued = await diagnose();
  if (queued) go('gap', queued.diagnosis);
}

function next(): string {
  const said = importWords.value;
  if (!mayImport()) return said.closed;
  if (sending.value) return said.next.sending;
  if (reading.value !== null) return said.next.reading;
  if (identifying.value) return said.identifying;
  if (refused.value) return said.next.refused;
  const found = log.value?.reading;
  if (!found) return armAlone.value ? said.alone.other : said.next.files;
  if (found.question) return said.next.question;
  if (!sound.value) return said.next.contradicted;
  return log.value?.identified ? said.next.identified : said.next.sound;
}

const page: Screen = { Page: Import, Actions, next };

export const importScreen = (): Screen => page;
