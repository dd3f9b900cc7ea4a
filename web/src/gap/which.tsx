import type { DiagnosisAnswer } from '../api';
import { percent } from '../ui/units';
import { words } from '../words';
import { EffectSize } from './effect-size';
import { type Candidate, candidatesOf, effectName, inWords, openOf } from './effect-values';
import { ShareBar } from './share-bar';

type Diagnosis = NonNullable<DiagnosisAnswer['result']>;

/** Probability from which an effect has a bar of its own. */
const SHOWN = 0.005;

/** Which effect it is, with probabilities; none and unknown take part. */
export function Which({ diagnosis }: { diagnosis: Diagnosis }) {
  const said = words.value.gap;
  const all = candidatesOf(diagnosis);
  const open = openOf(diagnosis);
  const openIds = open.map(({ id }) => id);
  const hasBar = ({ id, probability }: Candidate) => probability >= SHOWN || openIds.includes(id);
  const shown = all.filter(hasBar);
  const rest = all.filter((each) => !hasBar(each));
  const bars = [
    ...shown.map((each) => ({ ...each, name: effectName(each.id) })),
    { name: said.noGap, probability: diagnosis.none_probability, closure: null },
    { name: said.unknownEffect, probability: diagnosis.unknown_probability, closure: null },
  ].sort((one, other) => other.probability - one.probability);
  return (
    <section class="which">
      <h2>{said.which}</h2>
      <ul class="bars">
        {bars.map(({ name, probability, closure }) => (
          <li key={name}>
            <b>{name}</b>
            <ShareBar share={probability} />
            <span>
              <b>{percent(probability)}</b> {inWords(probability)}
              {closure !== null && <small>{said.closes(percent(closure))}</small>}
            </span>
          </li>
        ))}
      </ul>
      <Others candidates={rest} />
      {diagnosis.verdict !== 'no_gap' && open.map((each) => <EffectSize key={each.id} candidate={each} />)}
    </section>
  );
}

/** What the less probable ones would have closed: the wrong effect can close a good deal. */
function Others({ candidates }: { candidates: Candidate[] }) {
  const said = words.value.gap;
  if (candidates.length === 0) return null;
  const together = candidates.reduce((sum, each) => sum + each.probability, 0);
  const closing = candidates.toSorted((one, other) => other.closure - one.closure);
  return (
    <details class="others">
      <summary>{said.others(candidates.length, percent(together))}</summary>
      <ul>
        {closing.map(({ id, closure }) => (
          <li key={id}>
            {effectName(id)} <small>{said.closes(percent(Math.max(0, closure)))}</small>
          </li>
        ))}
      </ul>
    </details>
  );
}
