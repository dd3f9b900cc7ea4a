import type { JointGap } from '../api';
import { spelt } from '../ui/units';
import { words } from '../words';
import { times } from './effect-values';

/** What the joints show of the gap; nothing where nothing of them was recorded. */
export function JointTable({ joints }: { joints: JointGap[] }) {
  const said = words.value.gap;
  if (joints.length === 0) return null;
  return (
    <table class="joints">
      <caption>{said.joints}</caption>
      <thead>
        <tr>
          <th scope="col">{said.joint}</th>
          <th scope="col">{said.tracking}</th>
          <th scope="col">{said.torque}</th>
        </tr>
      </thead>
      <tbody>
        {joints.map((each) => (
          <tr key={each.joint}>
            <th scope="row">{each.joint}</th>
            <td>{trackingOf(each)}</td>
            <td>
              {each.torque_rms_n_m === null ? words.value.unknown : spelt('torque', each.torque_rms_n_m)}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function trackingOf({ tracking_rms_rad, tracking_noise_rad }: JointGap): string {
  if (tracking_rms_rad === null || !tracking_noise_rad) return words.value.unknown;
  return times(tracking_rms_rad / tracking_noise_rad);
}
