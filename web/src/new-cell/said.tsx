import type { DraftFinding, Flaw } from '../api';
import { FlawSentence } from '../ui/flaw-sentence';
import { MessageText } from '../ui/message-text';
import { messageOf } from '../ui/notice';
import { Told } from '../ui/told';
import { words } from '../words';
import type { Message } from '../words/catalogue';
import { sayPart, sayValue } from '../words/messages';
import { made, refused, type Step } from './draft';
import { newCellWords } from './new-cell-words';

/** Which step something can be changed at, by the key that it is about. */
const KEYS: [RegExp, Step][] = [
  [/adjacent|newcell-pair/, 'room'],
  [/home|^newcell-nearest/, 'home'],
  [/sensor\.|: sensor$|sensor-of-nobody/, 'sensor'],
  [/floor|payload_box|limits\.|newcell-box|newcell-payload-box/, 'room'],
  [/joint|acceleration|friction|mass-taken|inertia-taken/, 'joints'],
  [/frame|visual|robot\.urdf|newcell-sensor|newcell-felt|newcell-beside/, 'arm'],
];

function stepOf(text: string): Step {
  return KEYS.find(([key]) => key.test(text))?.[1] ?? 'check';
}

export const stepOfFinding = ({ message }: DraftFinding): Step => stepOf(sayValue(message.parameters?.where));

const ofJoint = ({ parameters }: Message) => typeof parameters?.joint === 'string';

export const stepOfNote = (note: Message): Step => (ofJoint(note) ? 'joints' : stepOf(note.code));

/** What was taken for a joint or a link, and why. */
export function notesOf(part: 'joint' | 'link', name: string): Message[] {
  return (made.value?.notes ?? []).filter(({ parameters }) => parameters?.[part] === name);
}

/** What is wrong or doubtful at a step, and what was taken there. */
export function Said({ step }: { step: Step }) {
  const said = newCellWords.value;
  const findings = (made.value?.findings ?? []).filter((finding) => stepOfFinding(finding) === step);
  const notes = (made.value?.notes ?? []).filter(
    (note) => stepOfNote(note) === step && !ofJoint(note) && typeof note.parameters?.link !== 'string',
  );
  return (
    <>
      <Findings findings={findings} />
      {notes.length > 0 && (
        <section class="taken">
          <h3>{said.taken}</h3>
          <ul>
            {notes.map((note) => (
              <li key={note.text}>
                <MessageText message={note} />
              </li>
            ))}
          </ul>
        </section>
      )}
    </>
  );
}

export function Findings({ findings }: { findings: DraftFinding[] }) {
  const said = newCellWords.value;
  if (findings.length === 0) return null;
  return (
    <ul class="findings">
      {findings.map(({ severity, message }) => (
        <li key={message.text} class={severity === 'wrong' ? 'abnormal' : 'tile'}>
          <b>
            <span aria-hidden="true">{severity === 'wrong' ? '✕' : '?'}</span> {said[severity]}
          </b>{' '}
          <Finding message={message} />
        </li>
      ))}
    </ul>
  );
}

/** Where it is, what is there, and what to do. */
function Finding({ message }: { message: Message }) {
  const said = words.value.cells;
  return (
    <>
      <code>{sayValue(message.parameters?.where)}</code>: {said.foundWord} {sayPart(message, 'found')},
      <span class="advice">
        {said.expected} {sayPart(message, 'expected')}
      </span>
    </>
  );
}

/** Why the last attempt came to nothing. */
export function RefusedHere() {
  const said = newCellWords.value;
  const shown = refused.value;
  if (shown === null) return null;
  return (
    <div class="warnings" role="alert">
      <h2>
        <span aria-hidden="true">▲</span> {said.refused}
      </h2>
      {shown.notice && <Told message={messageOf(shown.notice)} />}
      <ul>
        {shown.flaws.map((flaw) => (
          <li key={flaw.where + flaw.found}>{ownWords(flaw) ?? <FlawSentence {...flaw} />}</li>
        ))}
      </ul>
    </div>
  );
}

/** What the terminal says with its options is said here without. */
function ownWords({ code, parameters = {} }: Flaw): string | null {
  const said = newCellWords.value.said as Record<string, (name: string) => string>;
  const where = parameters.where as { parameters?: { name?: unknown } } | undefined;
  return said[code]?.(String(parameters.name ?? where?.parameters?.name ?? '')) ?? null;
}
