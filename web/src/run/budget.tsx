import type { IdentificationPublic } from '../api';
import { MessageText } from '../ui/message-text';
import { percent, type Quantity, shown } from '../ui/units';
import { words } from '../words';
import { say } from '../words/messages';

type Budget = NonNullable<IdentificationPublic['budget']>;

interface Part {
  title: string;
  /** Of the variance, 0 to 1. */
  share: number;
}

/** Parts below this share of the variance are drawn, not named. */
const NAMED = 0.01;

/** Where the uncertainty comes from, and how well the run alone repeats; nothing in results of earlier versions. */
export function Uncertainty({ answer }: { answer: IdentificationPublic }) {
  const said = words.value.result;
  const { budget } = answer;
  if (budget == null) return null;
  const { sources } = budget;
  return (
    <section class="budget">
      <h2>{said.budget}</h2>
      <Row
        name={said.mass}
        quantity="mass"
        repeats={[budget.repeatability_std[0] ?? null]}
        parts={sources.map(({ title, std }) => [say(title), [std[0] ?? null]])}
      />
      <Row
        name={said.com}
        quantity="length"
        repeats={budget.repeatability_com_std_m}
        parts={sources.map(({ title, com_std_m }) => [say(title), com_std_m])}
      />
      <Row
        name={said.inertia}
        quantity="inertia"
        repeats={budget.repeatability_inertia_com_std_kg_m2}
        parts={sources.map(({ title, inertia_com_std_kg_m2 }) => [say(title), inertia_com_std_kg_m2])}
      />
      <p class="hint">{said.budgetHint}</p>
      <Assumed budget={budget} />
    </section>
  );
}

interface RowProps {
  name: string;
  quantity: Quantity;
  /** Standard uncertainties by this run alone, SI. */
  repeats: (number | null)[];
  parts: [string, (number | null)[]][];
}

/** One of mass, centre of mass and inertia: its half-width by this run alone, and a bar of what its variance is made of. */
function Row({ name, quantity, repeats, parts }: RowProps) {
  const said = words.value.result;
  const all = sharesOf([[said.repeatability, repeats], ...parts]);
  if (all.length === 0) return null;
  const { half, unit } = shown(quantity, 0, Math.max(0, ...repeats.map((std) => std ?? 0)));
  return (
    <div class="budget-row">
      <h3>
        {name} {half !== null && <small class="budget-repeats">{said.repeats(`${half} ${unit}`)}</small>}
      </h3>
      <div class="budget-bar" aria-hidden="true">
        {all.map(({ title, share }) => (
          <i key={title} style={{ flexGrow: share }} />
        ))}
      </div>
      <p>
        {all
          .filter(({ share }) => share >= NAMED)
          .map(({ title, share }) => `${title} ${percent(share)}`)
          .join(' · ')}
      </p>
    </div>
  );
}

/** Shares of the variance, summed over the axes, the largest first; nothing where nothing is determined. */
function sharesOf(parts: [string, (number | null)[]][]): Part[] {
  const variances = parts.map(([title, stds]) => ({
    title,
    variance: stds.reduce<number>((sum, std) => sum + (std ?? 0) ** 2, 0),
  }));
  const total = variances.reduce((sum, { variance }) => sum + variance, 0);
  if (total === 0) return [];
  return variances
    .map(({ title, variance }) => ({ title, share: variance / total }))
    .sort((a, b) => b.share - a.share);
}

function Assumed({ budget }: { budget: Budget }) {
  if (budget.assumptions.length === 0) return null;
  return (
    <details>
      <summary>{words.value.result.assumed(budget.assumptions.length)}</summary>
      <ul>
        {budget.assumptions.map((each) => (
          <li key={each.code}>
            <MessageText message={each} />
          </li>
        ))}
      </ul>
    </details>
  );
}
