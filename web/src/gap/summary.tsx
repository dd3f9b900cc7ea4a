import type { DiagnosisPublic } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';
import { effectName, openOf } from './effect-values';
import { consequence, gapSentence } from './gap-sentences';

type Diagnosis = NonNullable<DiagnosisPublic['result']>;

/** The answer in the words of the trade, what to do with its figures, and what it means for the payload. */
export function Summary({ diagnosis }: { diagnosis: Diagnosis }) {
  const said = words.value.gap;
  const [best] = openOf(diagnosis);
  const advised = diagnosis.verdict === 'explained' || diagnosis.verdict === 'ambiguous';
  const atStake = consequence(diagnosis);
  const twin = diagnosis.twin ?? [];
  return (
    <section class="gap-summary">
      <h2>{gapSentence(diagnosis)}</h2>
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
        {twin.length > 0 && (
          <>
            <dt>{said.twinHad}</dt>
            <dd>{twin.map(effectName).join(', ')}</dd>
          </>
        )}
      </dl>
    </section>
  );
}
