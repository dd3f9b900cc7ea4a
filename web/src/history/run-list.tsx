import type { RunAnswer } from '../api';
import { Measured } from '../ui/measured';
import { nameOf } from '../ui/names';
import { to } from '../ui/route';
import { StateMark } from '../ui/state-mark';
import { Told } from '../ui/told';
import { moment } from '../ui/units';
import { words } from '../words';
import { pair, pick } from './history';

/** Runs with what they found, newest first; two of them can be picked. */
export function RunList({ runs }: { runs: RunAnswer[] }) {
  const said = words.value.history;
  return (
    <table class="run-list">
      <thead>
        <tr>
          <th scope="col">{said.compare}</th>
          <th scope="col">{said.run}</th>
          <th scope="col">{said.mass}</th>
          <th scope="col">{said.found}</th>
        </tr>
      </thead>
      <tbody>
        {runs.map((run) => (
          <Listed key={run.run} run={run} />
        ))}
      </tbody>
    </table>
  );
}

function Listed({ run }: { run: RunAnswer }) {
  const said = words.value.history;
  const when = moment(run.ended_at ?? run.requested_at);
  const found = run.result;
  return (
    <tr>
      <td>
        <input
          type="checkbox"
          class="pick"
          aria-label={said.pick(when)}
          disabled={found?.mass_kg == null}
          checked={pair.value.includes(run.run)}
          onChange={() => pick(run.run)}
        />
      </td>
      <th scope="row">
        <a href={to('runs', run.run)}>{when}</a>
        <StateMark state={run.state} /> <small>{run.payload}</small>
      </th>
      <td>{found && <Measured quantity="mass" value={found.mass_kg} std={found.mass_std_kg} />}</td>
      <td>
        {found ? (
          <span>{said.determined(found.determined)}</span>
        ) : (
          run.reason && <Told message={run.reason} />
        )}
        <small>{whoOf(run)}</small>
      </td>
    </tr>
  );
}

/** Who let it move, and who took its result for good. */
function whoOf(run: RunAnswer): string {
  const said = words.value.history;
  const by =
    run.released_by === null ? said.askedBy(nameOf(run.requested_by)) : said.by(nameOf(run.released_by));
  if (run.result === null) return by;
  return `${by}, ${run.accepted_by === null ? said.notAccepted : said.accepted(nameOf(run.accepted_by))}`;
}
