import type { Difference } from '../api';
import { payloadRows } from '../run/payload-rows';
import { number, type Quantity, spelt } from '../ui/units';
import { words } from '../words';
import type { Compared } from './comparison';

/** One parameter of two runs and the later minus the earlier; SI. */
export interface ComparedRow {
  key: string;
  part: 'mass' | 'com' | 'inertia' | 'force' | 'torque';
  axis: string;
  quantity: Quantity;
  /** Value and standard uncertainty in each run; none where they are not given in the frame that was compared in. */
  values: [number | null | undefined, number | null | undefined][];
  difference: Difference | undefined;
}

/** Mass, centre of mass, inertia about it. */
export function comparedPayload({ results, answer }: Compared): ComparedRow[] {
  const { parameters, com, inertia_com } = answer.comparison;
  const named = new Map([...com, ...inertia_com, ...parameters.slice(0, 1)].map((each) => [each.name, each]));
  const [first, second] = results.map(payloadRows);
  return (first ?? []).map(({ key, part, axis, quantity, value, std }, k) => {
    const other = second?.[k];
    const same = answer.frame === 'sensor' || part === 'mass';
    return {
      key,
      part,
      axis,
      quantity,
      values: same
        ? [
            [value, std],
            [other?.value, other?.std],
          ]
        : [],
      difference: named.get(NAMES[part] + axis),
    };
  });
}

const NAMES = { mass: 'm', com: 'c', inertia: 'I' };

/** The offsets of the sensor. */
export function comparedOffsets({ runs, answer }: Compared): ComparedRow[] {
  return answer.comparison.offset.map((difference, k) => ({
    key: difference.name,
    part: k < 3 ? 'force' : 'torque',
    axis: difference.name.slice(1),
    quantity: k < 3 ? 'force' : 'torque',
    values: runs.map(({ result }) => [result?.offset[k], result?.offset_std[k]]),
    difference,
  }));
}

/** In which parameter two runs differ most, in multiples of its uncertainty. */
export function mostClearly(compared: Compared): string {
  const size = ({ difference }: ComparedRow) => Math.abs(difference?.times_std ?? 0);
  const [most] = comparedPayload(compared).sort((one, other) => size(other) - size(one));
  if (most?.difference === undefined) return '';
  const { part, axis, quantity, difference } = most;
  const name = `${{ ...words.value.result, ...words.value.comparison }[part]} ${axis}`.trim();
  const shown = spelt(quantity, difference.value, difference.std);
  return words.value.comparison.mostClearly(name, shown, number(size(most), 1));
}
