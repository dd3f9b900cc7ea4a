import type { Also as Seen } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';
import { EffectParameters } from './effect-parameters';
import { effectName, times } from './effect-values';

/** What was seen elsewhere than in the wrench and matters: at the joints, in the readings, against the reference. */
export function Also({ also }: { also: Seen[] }) {
  const said = words.value.gap;
  const material = also.filter((each) => each.material);
  if (material.length === 0) return null;
  return (
    <section class="also">
      <h2>{said.also}</h2>
      <ul>
        {material.map((each) => (
          <li key={each.id}>
            <h3>{effectName(each.id)}</h3>
            <p class="sentence">
              <MessageText message={each.message} />
            </p>
            <dl class="advice">
              <dt>{said.todo}</dt>
              <dd>
                <MessageText message={each.advice} />
              </dd>
            </dl>
            <Measure seen={each} />
            <details class="others">
              <summary>{said.parameters}</summary>
              <EffectParameters parameters={each.parameters} />
            </details>
          </li>
        ))}
      </ul>
      <p class="hint">{said.alsoHint}</p>
    </section>
  );
}

/** What was seen there and does not matter. */
export function Unimportant({ seen }: { seen: Seen }) {
  return (
    <li>
      <b>{effectName(seen.id)}</b>
      <p>
        <MessageText message={seen.message} />
      </p>
      <Measure seen={seen} />
    </li>
  );
}

/** Where it was seen, and how it compares with what is expected there. */
function Measure({ seen: { side, times_expected } }: { seen: Seen }) {
  const said = words.value.gap;
  const measure = times_expected === null ? [] : [said.timesExpected(times(times_expected))];
  return <p class="hint">{[said.sides[side], ...measure].join('; ')}</p>;
}
