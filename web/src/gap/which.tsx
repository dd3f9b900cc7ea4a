import type { DiagnosisPublic } from '../api';
import { percent } from '../ui/units';
import { words } from '../words';
import { EffectSize } from './effect-size';
import { type Candidate, candidatesOf, effectName, inWords, openOf } from './effect-values';
import { ShareBar } from './share-bar';

type Diagnosis = NonNullable<DiagnosisPublic['result']>;

/** Probability from which an effect has a bar of its own. */
const SHOWN = 0.005;
/** So many of those that are open are shown with their sizes at once. */
const SETTLED_BETWEEN = 2;

/** Which effect it is, with probabilities; none and unknown take part. */
export function Which({ diagnosis }: { diagnosis: Diagnosis }) {
  const said = words.value.gap;
  const all = candidatesOf(diagnosis);
  const open = openOf(diagnosis);
  const named = namedOf(diagnosis, open);
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
      <Likely answers={diagnosis.likely ?? []} />
      <Others candidates={rest} />
      {named.map((each) => (
        <EffectSize key={each.id} candidate={each} />
      ))}
      <Rejected candidates={open.filter((each) => !named.includes(each))} />
    </section>
  );
}

/** The answers that hold the truth in nine of ten cases, where there are several. */
function Likely({ answers }: { answers: string[] }) {
  const said = words.value.gap;
  if (answers.length < 2) return null;
  const others: Record<string, string> = { none: said.noGap, unknown: said.unknownEffect };
  return <p>{said.likelySet(answers.map((id) => others[id] ?? effectName(id)))}</p>;
}

/** What the verdict names: the most probable where it is explained, all that are open where it is not settled. */
function namedOf({ verdict }: Diagnosis, open: Candidate[]): Candidate[] {
  if (verdict === 'explained') return open.slice(0, 1);
  return verdict === 'ambiguous' ? open.slice(0, SETTLED_BETWEEN) : [];
}

/** Sizes that rejected effects would have. */
function Rejected({ candidates }: { candidates: Candidate[] }) {
  if (candidates.length === 0) return null;
  return (
    <details class="others">
      <summary>{words.value.gap.rejected(candidates.length)}</summary>
      {candidates.map((each) => (
        <EffectSize key={each.id} candidate={each} />
      ))}
    </details>
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
