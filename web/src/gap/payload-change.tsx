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
                  <Measured quantity={quantity} value={knownValue(before, k)} std={before.std[k]} />
                </td>
                <td>
                  <Measured quantity={quantity} value={knownValue(after, k)} std={after.std[k]} />
                </td>
                <td>
                  <Changed
                    quantity={quantity}
                    from={knownValue(before, k)}
                    to={knownValue(after, k)}
                    times={times[k]}
                  />
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

/** One of the ten; null where the recording does not determine it. */
function knownValue({ phi, determined }: Payload['before'], k: number): number | null {
  return determined?.[k] === false ? null : (phi[k] ?? null);
}

interface ChangedProps {
  quantity: Quantity;
  from: number | null;
  to: number | null;
  times: number | null | undefined;
}

function Changed({ quantity, from, to, times }: ChangedProps) {
  if (from === null || to === null) return null;
  return (
    <>
      {spelt(quantity, to - from)} <small>{held(times)}</small>
    </>
  );
}

/** A change against the intervals before and after taken together: one that lies within either of them is none. */
function held(times: number | null | undefined): string {
  if (times == null) return '';
  const said = words.value.gap;
  const size = Math.abs(times);
  return size <= 1 ? `= ${said.notSignificant}` : `≠ ${said.significant(number(size, size < 10 ? 1 : 0))}`;
}
