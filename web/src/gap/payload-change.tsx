import type { DiagnosisPublic } from '../api';
import { Measured } from '../ui/measured';
import { number, type Quantity, spelt } from '../ui/units';
import { words } from '../words';

type Payload = NonNullable<NonNullable<DiagnosisPublic['result']>['payload']>;

const MOMENTS = ['x', 'y', 'z'];
const INERTIA = ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'];

/** What the effect does to the ten parameters of the payload. */
export function PayloadChange({ payload }: { payload: Payload }) {
  const { before, after, change_over_interval: times } = payload;
  const said = words.value.gap;
  const rows: [string, Quantity][] = [
    [words.value.result.mass, 'mass'],
    ...MOMENTS.map((axis): [string, Quantity] => [`${said.moment} ${axis}`, 'moment']),
    ...INERTIA.map((axis): [string, Quantity] => [`${words.value.result.inertia} ${axis}`, 'inertia']),
  ];
  return (
    <section class="payload-change">
      <h2>{said.payload}</h2>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys */}
      <div class="scrolls" tabIndex={0}>
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
                <td>
                  {spelt(quantity, (after.phi[k] ?? 0) - (before.phi[k] ?? 0))}{' '}
                  <small>{held(times[k])}</small>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="hint">
        {words.value.interval}, {said.payloadNote}. {said.changeNote}
      </p>
    </section>
  );
}

/** A change against the intervals before and after taken together: one that lies within either of them is none. */
function held(times: number | null | undefined): string {
  if (times == null) return '';
  const said = words.value.gap;
  const size = Math.abs(times);
  return size <= 1 ? `= ${said.notSignificant}` : `≠ ${said.significant(number(size, size < 10 ? 1 : 0))}`;
}
