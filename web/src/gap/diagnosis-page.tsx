import type { DiagnosisPublic } from '../api';
import { queueMotion } from '../run/runs';
import { language } from '../session/settings';
import { addressOf } from '../ui/client';
import { JobProgress } from '../ui/job-progress';
import { isUnderWay } from '../ui/jobs';
import { MessageText } from '../ui/message-text';
import { Press } from '../ui/press';
import { Reading } from '../ui/reading';
import { Reserved } from '../ui/reserved';
import { go } from '../ui/route';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { cancelDiagnosis, diagnosis } from './diagnoses';
import { type Candidate, candidatesOf, effectName } from './effect-values';
import { Evidence } from './evidence';
import { NextMotion } from './next-motion';
import { addEffect, isAdded } from './twin';
import { Verdict } from './verdict';

type Result = NonNullable<DiagnosisPublic['result']>;

function Diagnosis() {
  const shown = diagnosis.value;
  if (shown === null) return <Reading />;
  if (shown.result === null) return <Waiting shown={shown} />;
  const { result } = shown;
  return (
    <div class="page diagnosis">
      <Verdict instruction={result.instruction} shown={shown} />
      {result.next_experiment && <NextMotion motion={result.next_experiment} diagnosis={shown.diagnosis} />}
      <Evidence diagnosis={result} file={fileOf(shown)} when={shown.requested_at} />
      <section>
        <p class="downloads">
          <a
            class="download"
            href={addressOf(
              '/api/diagnoses/{diagnosis}/report',
              { diagnosis: shown.diagnosis },
              { language: language.value },
            )}
            target="_blank"
            rel="noreferrer"
          >
            {words.value.gap.report}
          </a>
          <Press act={() => window.print()}>{words.value.result.print}</Press>
        </p>
      </section>
    </div>
  );
}

/** By what was diagnosed and the tool. */
function fileOf({ run, name, diagnosis, tool }: DiagnosisPublic) {
  return ['diagnosis', run ?? name ?? diagnosis, tool];
}

function Waiting({ shown }: { shown: DiagnosisPublic }) {
  const said = words.value.gap;
  return (
    <div class="page">
      <section>
        <h1>{said.title}</h1>
        <JobProgress
          title={shown.run === null ? (shown.name ?? said.upload) : said.run(shown.run)}
          job={shown}
        />
        {shown.where && (
          <p class="where-so-far">
            <MessageText message={shown.where} /> {isUnderWay(shown) && said.causeSought}
          </p>
        )}
      </section>
    </div>
  );
}

function Actions() {
  const said = words.value.gap;
  const shown = diagnosis.value;
  if (shown === null) return null;
  const proposed = shown.cell !== null && (shown.result?.next_experiment?.planned ?? false);
  return (
    <>
      {isUnderWay(shown) && (
        <Reserved roles={['engineer', 'operator']} act={() => cancelDiagnosis(shown.diagnosis)}>
          {said.cancel}
        </Reserved>
      )}
      {proposed && (
        <Reserved
          kind="primary"
          roles={['operator']}
          act={async () => go('runs', (await queueMotion(shown.diagnosis)).run)}
        >
          {said.planMotion}
        </Reserved>
      )}
      <AddToTwin shown={shown} kind={proposed ? 'plain' : 'primary'} />
      <Press act={() => go('gap')}>{said.back}</Press>
    </>
  );
}

/** The most probable effect goes into the twin, where the verdict names one that the twin takes. */
function AddToTwin({ shown, kind }: { shown: DiagnosisPublic; kind: 'plain' | 'primary' }) {
  const said = words.value.gap;
  const { result, cell } = shown;
  if (result === null || cell === null) return null;
  const best = addableOf(result);
  if (best === undefined) return null;
  const added = isAdded(shown, best.id);
  return (
    <>
      {added && <p role="status">✓ {said.added(effectName(best.id))}</p>}
      <Reserved
        kind={kind}
        roles={['engineer']}
        disabled={added}
        act={() => addEffect(cell, shown.diagnosis, best.id)}
      >
        {said.add}
        <small>{effectName(best.id)}</small>
      </Reserved>
    </>
  );
}

/** The most probable explanation, where the verdict names it and the twin takes it. */
function addableOf(result: Result): Candidate | undefined {
  const [best] = candidatesOf(result);
  return isNamed(result) && best?.addable ? best : undefined;
}

const isNamed = ({ verdict }: Result) => verdict === 'explained' || verdict === 'ambiguous';

function next(): string {
  const said = words.value.gap;
  const shown = diagnosis.value;
  if (shown === null || isUnderWay(shown)) return said.jobNext;
  if (shown.result === null) return said.failedNext;
  const { verdict, also = [], lacking } = shown.result;
  if (isNamed(shown.result) && shown.cell === null) return said.noCell;
  if (verdict === 'explained' && addableOf(shown.result) === undefined) return said.adviceNext;
  if (verdict === 'ambiguous' && !shown.result.next_experiment?.planned) return said.unsettledNext;
  if (verdict === 'no_gap' && also.some(({ material }) => material)) return said.adviceNext;
  if (lacking?.code.startsWith('setup-')) return said.adviceNext; // another recording would have the same slip
  return said.verdictNext[verdict];
}

export const diagnosisScreen: Screen = { Page: Diagnosis, Actions, next };
