import type { DiagnosisAnswer } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';
import { effectName, openOf } from './effect-values';
import { consequence, gapSentence } from './gap-sentences';

type Diagnosis = NonNullable<DiagnosisAnswer['result']>;

/** The answer in one sentence, what to do, and what it means for the payload. */
export function Verdict({ diagnosis }: { diagnosis: Diagnosis }) {
  const said = words.value.gap;
  const [best] = openOf(diagnosis);
  const advised = diagnosis.verdict === 'explained' || diagnosis.verdict === 'ambiguous';
  const atStake = consequence(diagnosis);
  return (
    <section class="gap-verdict">
      <h1>{gapSentence(diagnosis)}</h1>
      {diagnosis.lacking && (
        <p class="hint">
          <MessageText message={diagnosis.lacking} />
        </p>
      )}
      <dl class="advice">
        {advised && best && (
          <>
            <dt>{said.todo}</dt>
            {best.advice.map((advice) => (
              <dd key={advice.text}>
                <MessageText message={advice} />
              </dd>
            ))}
          </>
        )}
        {advised && best?.whyNot && (
          <>
            <dt>{said.notForTwin}</dt>
            <dd>
              <MessageText message={best.whyNot} />
            </dd>
          </>
        )}
        {atStake && (
          <>
            <dt>{said.payloadEffect}</dt>
            <dd>{atStake}</dd>
          </>
        )}
        {(diagnosis.twin ?? []).length > 0 && (
          <>
            <dt>{said.twinHad}</dt>
            <dd>{diagnosis.twin?.map(effectName).join(', ')}</dd>
          </>
        )}
      </dl>
    </section>
  );
}
