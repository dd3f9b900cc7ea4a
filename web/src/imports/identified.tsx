import { useEffect, useRef } from 'preact/hooks';
import type { IdentificationPublic } from '../api';
import { Uncertainty } from '../run/budget';
import { GoodEnough } from '../run/good-enough';
import { ParameterTable } from '../run/parameter-table';
import { resultSentence } from '../run/result-sentence';
import { Verification } from '../run/verification';
import { Warnings } from '../run/warnings';
import { Workpiece } from '../run/workpiece';
import { language } from '../session/settings';
import { addressOf } from '../ui/client';
import { MessageText } from '../ui/message-text';
import { words } from '../words';
import { importWords } from './import-words';
import { identifying, log, reading } from './imports';

/** The payload that was identified from the log, drawn as a run's is; nothing before somebody asked for it. */
export function Identified() {
  const said = importWords.value;
  if (identifying.value)
    return (
      <div>
        <progress aria-label={said.identifying} />
        <p role="status">{said.identifying} …</p>
      </div>
    );
  const answer = reading.value === null && log.value?.identified;
  return answer ? <Payload answer={answer} /> : null;
}

function Payload({ answer }: { answer: IdentificationPublic }) {
  const said = words.value.result;
  const determined = answer.mass_kg !== null;
  const shown = useRef<HTMLElement>(null);
  useEffect(() => shown.current?.scrollIntoView({ block: 'nearest' }), []);
  return (
    <section class="stack identified" aria-label={said.title} ref={shown}>
      <h2>{said.title}</h2>
      <p class="verdict-words" role="status">
        {determined ? resultSentence(answer) : <MessageText message={answer.verdict} />}
      </p>
      <ComparedWith files={log.value?.without ?? []} />
      {determined && <GoodEnough requirement={answer.requirement} />}
      <Warnings all={answer.warnings} />
      {determined && (
        <>
          <ParameterTable answer={answer} />
          <p class="hint">
            {words.value.interval}, {said.frame}
          </p>
          <Workpiece answer={answer} />
          <Uncertainty answer={answer} />
          <Verification parts={answer.verification} />
        </>
      )}
      <Downloads />
    </section>
  );
}

/** The log without the payload that it was compared with; nothing where it was identified alone. */
function ComparedWith({ files }: { files: string[] }) {
  return files.length > 0 ? <p>{importWords.value.alone.compared(files.join(', '))}</p> : null;
}

function Downloads() {
  const path = { log_import: log.value?.log_import ?? '' };
  return (
    <p class="downloads">
      <a
        class="download"
        href={addressOf('/api/imports/{log_import}/report', path, { language: language.value })}
        target="_blank"
        rel="noreferrer"
      >
        {words.value.result.report}
      </a>
      <a class="download" href={addressOf('/api/imports/{log_import}/result', path)} download>
        {importWords.value.result}
      </a>
    </p>
  );
}
