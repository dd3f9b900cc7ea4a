import { words } from '../words';
import { EffectParameters } from './effect-parameters';
import { type Candidate, effectName } from './effect-values';

/** How large an effect is, or each of two. */
export function EffectSize({ candidate }: { candidate: Candidate }) {
  const said = words.value.gap;
  return (
    <section class="effect-size">
      <h3>
        {said.parameters}: {effectName(candidate.id)}
      </h3>
      {Object.entries(candidate.parameters).map(([effect, parameters]) => (
        <EffectParameters key={effect} parameters={parameters} />
      ))}
      <p class="hint">{words.value.interval}</p>
    </section>
  );
}
