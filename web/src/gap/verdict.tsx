import type { DiagnosisAnswer } from '../api';
import { EngineSentence } from '../ui/engine-sentence';
import { words } from '../words';
import { engineSaid } from '../words/engine-words';
import { effectName, openOf } from './effect-values';
import { consequence, gapSentence } from './gap-sentences';
import { remarkSaid } from './remarks';

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
          <EngineSentence said={remarkSaid(diagnosis.lacking)} english={diagnosis.summary} />
        </p>
      )}
      <dl class="advice">
        {advised && best && (
          <>
            <dt>{said.todo}</dt>
            {best.advice.map(
              ([effect, english]) =>
                english && (
                  <dd key={effect}>
                    <EngineSentence said={said.remedies[effect]} english={english} />
                  </dd>
                ),
            )}
          </>
        )}
        {advised && best?.whyNot && (
          <>
            <dt>{said.notForTwin}</dt>
            <dd>
              <EngineSentence said={engineSaid(best.whyNot)} english={best.whyNot} />
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
