import type { DiagnosisAnswer } from '../api';
import { significance } from '../run/parameter-table';
import { Measured } from '../ui/measured';
import type { Quantity } from '../ui/units';
import { words } from '../words';

type Payload = NonNullable<NonNullable<DiagnosisAnswer['result']>['payload']>;

const MOMENTS = ['x', 'y', 'z'];
const INERTIA = ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'];

/** What the effect does to the ten parameters of the payload. */
export function PayloadChange({ payload: { before, after } }: { payload: Payload }) {
  const said = words.value.gap;
  const rows: [string, Quantity][] = [
    [words.value.result.mass, 'mass'],
    ...MOMENTS.map((axis): [string, Quantity] => [`${said.moment} ${axis}`, 'moment']),
    ...INERTIA.map((axis): [string, Quantity] => [`${words.value.result.inertia} ${axis}`, 'inertia']),
  ];
  return (
    <section class="payload-change">
      <h2>{said.payload}</h2>
      <table>
        <thead>
          <tr>
            <th scope="col">{words.value.result.parameter}</th>
            <th scope="col">{said.before}</th>
            <th scope="col">{said.after}</th>
            <th scope="col">{said.change}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map(([name, quantity], k) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>
                <Measured quantity={quantity} value={before.phi[k]} std={before.std[k]} />
              </td>
              <td>
                <Measured quantity={quantity} value={after.phi[k]} std={after.std[k]} />
              </td>
              <td>{significance({ value: before.phi[k], std: after.std[k], reference: after.phi[k] })}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="hint">
        {words.value.interval}, {said.payloadNote}.
      </p>
    </section>
  );
}
