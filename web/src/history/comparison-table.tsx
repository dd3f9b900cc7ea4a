import type { Difference } from '../api';
import { significance } from '../run/parameter-table';
import { Measured } from '../ui/measured';
import { INTERVAL, type Quantity } from '../ui/units';
import { words } from '../words';
import type { ComparedRow } from './comparison-rows';
import { DifferenceMark } from './difference-mark';

interface Props {
  title: string;
  rows: ComparedRow[];
  /** When each run was, in words. */
  when: string[];
}

/** Parameters of two runs, their differences, and whether those are more than chance: in words, a number and a mark. */
export function ComparisonTable({ title, rows, when }: Props) {
  const said = words.value.comparison;
  const named = { ...words.value.result, force: said.force, torque: said.torque };
  return (
    <table class="comparison-table">
      <thead>
        <tr>
          <th scope="col">{title}</th>
          <th scope="col">
            {when.map((each, k) => (
              <span key={each}>
                {'AB'[k]}: {each}
              </span>
            ))}
          </th>
          <th scope="col">{said.difference}</th>
          <th scope="col">{said.times}</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={row.key}>
            <th scope="row">{`${named[row.part]} ${row.axis}`.trim()}</th>
            <td>
              {row.values.length === 0 && '–'}
              {row.values.map(([value, std], k) => (
                <div key={'AB'[k]}>
                  <small>{'AB'[k]}</small> <Measured quantity={row.quantity} value={value} std={std} />
                </div>
              ))}
            </td>
            <Differing quantity={row.quantity} difference={row.difference} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Differing({ quantity, difference }: { quantity: Quantity; difference: Difference | undefined }) {
  if (difference === undefined) return <td colSpan={2}>–</td>;
  const { value, std, times_std } = difference;
  return (
    <>
      <td>
        <Measured quantity={quantity} value={value} std={std} />
      </td>
      <td>
        <span class="significance">
          <DifferenceMark times={times_std / INTERVAL} />
          {significance({ value, std, reference: 0 })}
        </span>
      </td>
    </>
  );
}
