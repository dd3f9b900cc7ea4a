import type { RunPlan } from '../api';
import { clock, spelt } from '../ui/units';
import { words } from '../words';

/** Each pose of a plan: what is nearest there, and where the load would fly if it let go. */
export function PlannedPoses({ plan }: { plan: RunPlan }) {
  const said = words.value.preview;
  return (
    <table class="poses">
      <thead>
        <tr>
          <th scope="col">{said.pose}</th>
          <th scope="col">{said.clearance}</th>
          <th scope="col">{said.letGo}</th>
        </tr>
      </thead>
      <tbody>
        {plan.summary.poses.map(({ axis, least_clearance_m, nearest, rotation_s }) => {
          const thrown = plan.throws.find((each) => each.axis === axis);
          return (
            <tr key={axis}>
              <th scope="row">
                {axis} {rotation_s != null && <small>↻ {clock(rotation_s)}</small>}
              </th>
              <td>{said.from(spelt('length', least_clearance_m), nearest)}</td>
              <td>{thrown ? said.from(spelt('length', thrown.distance_m), thrown.zone) : '–'}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
