import type { ControlPublic } from '../api';
import { cells } from '../cells/cells';
import { ask } from '../ui/client';
import { nameOf } from '../ui/names';
import { percent, seconds } from '../ui/units';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';
import { milliseconds } from './milliseconds';
import { OwnConnection } from './own-connection';

const ASK_MS = 2000;

/** How good the connections are that runs depend on: of this device, and of every console that is in control. */
export function ConnectionsSection() {
  const { answer } = useAnswer(readControl, ASK_MS);
  const all = answer.value ?? [];
  return (
    <div class="halves">
      <OwnConnection cells={all} />
      <InControl all={all} />
    </div>
  );
}

function readControl(): Promise<ControlPublic[]> {
  const names = (cells.value ?? []).map(({ name }) => name);
  return Promise.all(names.map((cell) => ask('GET /api/control/{cell}', { path: { cell } })));
}

function InControl({ all }: { all: ControlPublic[] }) {
  const said = adminWords.value.connections;
  return (
    <section>
      <h2>{said.control}</h2>
      <ul class="tiles">
        {all.map((each) => (
          <li class="tile" key={each.cell} data-cell={each.cell}>
            <div>
              <b>
                <code>{each.cell}</code>
              </b>
              <span>{each.holder === null ? said.nobody : <code>{nameOf(each.holder)}</code>}</span>
              {each.holder !== null && <Link control={each} />}
            </div>
          </li>
        ))}
      </ul>
      <p class="hint">{said.nobodyHint}</p>
    </section>
  );
}

function Link({ control: { link, lease_s } }: { control: ControlPublic }) {
  const said = adminWords.value.connections;
  if (link === null) return <small>{said.measuringLink}</small>;
  const trip = said.within(milliseconds(link.round_trip_p50_s), milliseconds(link.round_trip_p99_s));
  return (
    <>
      <small>
        {said.link}: {trip}
      </small>
      <small>
        {said.gap}: {said.limit(seconds(link.longest_gap_s), seconds(lease_s))}; {said.lost}:{' '}
        {percent(link.lost_share)}
      </small>
      {link.advised ? (
        <span>✓ {said.fine}</span>
      ) : (
        <span class="abnormal">
          <span aria-hidden="true">▲</span> {said.bad}
        </span>
      )}
    </>
  );
}
