import type { EventMessage } from '../api';
import { to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { spelt } from '../ui/units';
import { words } from '../words';
import { events } from './live';
import { ProposedBy } from './proposed-by';
import { run } from './run';
import { activeRun } from './runs';

function Planning() {
  const said = words.value.planning;
  const found = events.value.flatMap((message) => lineOf(message));
  const waits =
    run.value && activeRun.value && activeRun.value.run !== run.value.run ? activeRun.value.run : '';
  return (
    <section>
      <h1>{said.title}</h1>
      <ProposedBy />
      {waits ? <Queue first={waits} /> : <p>{said.doing}</p>}
      <ol class="found">
        {found.map(([what, value]) => (
          <li key={what}>
            <span aria-hidden="true">✓</span> {what} <small>{value}</small>
          </li>
        ))}
      </ol>
    </section>
  );
}

/** A cell has one run at a time; another one has to end first. */
function Queue({ first }: { first: string }) {
  return (
    <p>
      {words.value.planning.queued}{' '}
      <a class="download" href={to('runs', first)}>
        {words.value.setup.open}
      </a>
    </p>
  );
}

/** What planning has found, and how much room there is. */
function lineOf({ event }: EventMessage): [string, string][] {
  const said = words.value.planning;
  if (event.kind === 'start_configuration_found') {
    return [[said.found(event.axis), `${spelt('length', event.clearance_m)} · ${event.nearest}`]];
  }
  if (event.kind !== 'transfer_planned') return [];
  const toward = event.axis === 'home' ? said.home : event.axis;
  return [[said.path(toward), `${spelt('time', event.robot_s)}`]];
}

export const planning: Screen = { Page: Planning, next: () => words.value.planning.next };
