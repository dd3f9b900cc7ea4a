import type { CellNow } from '../api';
import { robots, stopRobot } from '../run/now';
import { lost } from '../ui/connection';
import { Press } from '../ui/press';
import { StateMark } from '../ui/state-mark';
import { timeOfDay } from '../ui/units';
import { words } from '../words';

/** States in which the robot has been released to move, and does, stands on hold, or waits. */
const RELEASED = new Set<CellNow['state']>([
  'Starting',
  'Execute',
  'Holding',
  'Held',
  'Unholding',
  'Suspending',
  'Suspended',
  'Unsuspending',
]);

/** Every robot that a run of the service has, each with its STOP: for whoever is in front of one, signed in or not. */
export function ActiveRobots() {
  const said = words.value.now;
  const all = robots.value ?? [];
  if (all.length === 0) return null;
  return (
    <section class="active-robots">
      <h2>{said.active}</h2>
      <ul>
        {all.map((each) => (
          <Robot key={each.cell} {...each} />
        ))}
      </ul>
      <p class="hint">{said.anybody}</p>
    </section>
  );
}

function Robot({ cell, state, since }: CellNow) {
  const said = words.value.now;
  return (
    <li class="tile" data-cell={cell}>
      <div>
        <b>{cell}</b>
        {state && <StateMark state={state} />}
        {since && <small>{said.since(timeOfDay(Date.parse(since)))}</small>}
      </div>
      {RELEASED.has(state) && !lost.value && (
        <Press kind="stop" act={() => stopRobot(cell)}>
          <span aria-hidden="true">■</span> {said.stop(cell)}
        </Press>
      )}
    </li>
  );
}
