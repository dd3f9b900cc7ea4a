import type { RunPublic } from '../api';
import { Measured } from '../ui/measured';
import { nameOf } from '../ui/names';
import { to } from '../ui/route';
import { StateMark } from '../ui/state-mark';
import { Told } from '../ui/told';
import { moment } from '../ui/units';
import { words } from '../words';
import { pick, picked } from './history';
import { type Column, order, sortBy, sorted } from './run-order';
import { identifiersOf } from './run-text';

/** Runs with what they found, in the order that a tap on a column chooses; two or more of them can be picked. */
export function RunList({ runs }: { runs: RunPublic[] }) {
  const said = words.value.history;
  const has = (name: 'serial_number' | 'order_id' | 'work_order') =>
    runs.some((run) => identifiersOf(run)[name] !== '');
  const ordered = has('order_id') || has('work_order');
  const columns: [Column, string][] = [
    ['run', said.run],
    ['tool', said.tool],
    ...(has('serial_number') ? [['serial_number', said.serialNumber] as [Column, string]] : []),
    ...(ordered ? [['order_id', said.orderId] as [Column, string]] : []),
    ['mass', said.mass],
    ['found', said.found],
  ];
  const shown = columns.map(([column]) => column);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys
    <div class="scrolls" tabIndex={0}>
      <table class="run-list">
        <thead>
          <tr>
            <th scope="col">{said.compare}</th>
            {columns.map(([column, name]) => (
              <Heading key={column} column={column} name={name} />
            ))}
          </tr>
        </thead>
        <tbody>
          {sorted(runs).map((run) => (
            <Listed key={run.run} run={run} shown={shown} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Heading({ column, name }: { column: Column; name: string }) {
  const { column: by, rises } = order.value;
  const sort = by === column ? (rises ? 'ascending' : 'descending') : 'none';
  return (
    <th scope="col" aria-sort={sort}>
      <button type="button" class="sort" onClick={() => sortBy(column)}>
        {name} <span aria-hidden="true">{{ ascending: '▲', descending: '▼', none: '' }[sort]}</span>
      </button>
    </th>
  );
}

function Listed({ run, shown }: { run: RunPublic; shown: Column[] }) {
  const said = words.value.history;
  const when = moment(run.ended_at ?? run.requested_at);
  const found = run.result;
  const { serial_number, order_id, work_order } = identifiersOf(run);
  return (
    <tr>
      <td>
        <input
          type="checkbox"
          class="pick"
          aria-label={said.pick(when)}
          disabled={found?.mass_kg == null}
          checked={picked.value.includes(run.run)}
          onChange={() => pick(run.run)}
        />
      </td>
      <th scope="row">
        <a href={to('runs', run.run)}>{when}</a>
        <StateMark state={run.state} />
      </th>
      <td>{run.order.empty ? words.value.setup.empty : run.payload}</td>
      {shown.includes('serial_number') && <td class="identifier">{serial_number}</td>}
      {shown.includes('order_id') && (
        <td class="identifier">
          {order_id} {work_order && <small>{said.workOrder(work_order)}</small>}
        </td>
      )}
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
function whoOf(run: RunPublic): string {
  const said = words.value.history;
  const by =
    run.released_by === null ? said.askedBy(nameOf(run.requested_by)) : said.by(nameOf(run.released_by));
  if (run.result === null) return by;
  return `${by}, ${run.accepted_by === null ? said.notAccepted : said.accepted(nameOf(run.accepted_by))}`;
}
