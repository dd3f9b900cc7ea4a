import { Measured } from '../ui/measured';
import { INTERVAL, number, shown } from '../ui/units';
import { words } from '../words';
import { type Body, payloadRows, type Row } from './payload-rows';

/** The ten parameters with their intervals, beside the reference where there is one. */
export function ParameterTable({ answer }: { answer: Body }) {
  const said = words.value.result;
  const referenced = answer.reference !== null;
  return (
    <table class="parameters">
      <thead>
        <tr>
          <th scope="col">{said.parameter}</th>
          <th scope="col">{said.value}</th>
          {referenced && <th scope="col">{said.reference}</th>}
          {referenced && <th scope="col">{said.difference}</th>}
        </tr>
      </thead>
      <tbody>
        {payloadRows(answer).map((row) => (
          <tr key={row.key}>
            <th scope="row">{`${said[row.part]} ${row.axis}`.trim()}</th>
            <td class="measured-value">
              <Measured quantity={row.quantity} value={row.value} std={row.std} reason={row.reason} />
            </td>
            {referenced && (
              <td data-column={said.reference}>
                {row.reference == null ? '–' : shown(row.quantity, row.reference, row.std).value}
              </td>
            )}
            {referenced && <td>{significance(row)}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Whether a value lies within its interval of the reference, or by how many intervals it does not. */
export function significance({ value, std, reference }: Pick<Row, 'value' | 'std' | 'reference'>): string {
  const said = words.value.result;
  if (value == null || std == null || reference == null || std <= 0) return '–';
  const times = Math.abs(value - reference) / (INTERVAL * std);
  return times <= 1 ? `= ${said.within}` : `≠ ${said.beyond(number(times, times < 10 ? 1 : 0))}`;
}
