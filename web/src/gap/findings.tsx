import type { DiagnosisPublic } from '../api';
import { MessageText } from '../ui/message-text';
import { number } from '../ui/units';
import { words } from '../words';
import { Unimportant } from './also';
import { EffectParameters } from './effect-parameters';
import { effectName } from './effect-values';

type Diagnosis = NonNullable<DiagnosisPublic['result']>;

/** What cannot be told apart, what was found but does not matter, and what the recording cannot say. */
export function Findings({ diagnosis }: { diagnosis: Diagnosis }) {
  const said = words.value.gap;
  const { indistinguishable, minor, limits } = diagnosis;
  const beside = (diagnosis.also ?? []).filter(({ material }) => !material);
  return (
    <>
      {indistinguishable.length > 0 && (
        <section class="ties">
          <h2>{said.ties}</h2>
          <p class="hint">{said.tiesWhy}</p>
          <ul>
            {indistinguishable.map(({ ids, distance_sigma, splits }) => (
              <li key={ids.join()}>
                <b>{ids.map(effectName).join(' – ')}</b>
                <p>{said.apart(number(distance_sigma, 1))}</p>
                <p>
                  {said.settles}: <MessageText message={splits} />
                </p>
              </li>
            ))}
          </ul>
        </section>
      )}
      {minor.length + beside.length > 0 && (
        <section class="minor">
          <h2>{said.minor}</h2>
          <ul>
            {minor.map(({ id, parameters }) => (
              <li key={id}>
                <b>{effectName(id)}</b>
                <EffectParameters parameters={parameters} />
              </li>
            ))}
            {beside.map((each) => (
              <Unimportant key={each.id} seen={each} />
            ))}
          </ul>
        </section>
      )}
      {limits.length > 0 && (
        <details class="others">
          <summary>{said.limits}</summary>
          <ul>
            {limits.map((each) => (
              <li key={each.text}>
                <MessageText message={each} />
              </li>
            ))}
          </ul>
        </details>
      )}
    </>
  );
}
