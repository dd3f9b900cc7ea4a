import { effect, signal } from '@preact/signals';
import type { PlanPublic, PlanSummary } from '../api';
import { cell } from '../cells/cells';
import { may } from '../session/session';
import { type Fact, Facts } from '../ui/facts';
import { Press } from '../ui/press';
import type { Screen } from '../ui/screen';
import { clock, spelt } from '../ui/units';
import { words } from '../words';
import { holder, mine, takeControl } from './control';
import { LinkFigures } from './link-figures';
import { offered_s, plan, releasePlan, showPlan } from './plan';
import { PlannedPoses } from './planned-poses';
import { ProposedBy } from './proposed-by';
import { run } from './run';
import { betweenSaid, SecondLook } from './second-look';

/** The plan whose release was asked for and waits for its START: any other plan has to be asked for anew. */
const armed = signal<PlanPublic | null>(null);
effect(() => {
  if (armed.value !== plan.value || offered_s.value === 0) armed.value = null;
});

/** What was refused has to be asked for anew. */
async function start(shown: PlanPublic): Promise<void> {
  try {
    await releasePlan(shown);
  } catch (refused) {
    armed.value = null;
    throw refused;
  }
}

function Preview() {
  const said = words.value.preview;
  const found = plan.value?.plan;
  return (
    <section>
      <h1>{said.title}</h1>
      <ProposedBy />
      {run.value?.order.empty && (
        <p class="warnings" role="alert">
          <span aria-hidden="true">▲</span> <b>{said.takeOff}</b>
        </p>
      )}
      <Validity />
      <LinkFigures />
      {found && (
        <>
          <Facts
            facts={[
              { name: said.robotTime, value: clock(found.summary.robot_s) },
              {
                name: said.margin,
                value: `+ ${spelt('length', found.summary.least_margin_m)}`,
                note: said.marginNote,
              },
              ...leastDistance(found.summary),
              { name: said.speed, value: spelt('speed', cell.value?.limits?.cartesian_speed_m_s ?? 0) },
              { name: said.zones, value: cell.value?.zones?.map((zone) => zone.name).join(', ') },
            ]}
          />
          <PlannedPoses plan={found} />
          <SecondLook summary={found.summary} />
          <p class="hint">
            {said.plan} {found.sha256.slice(0, 12)}
          </p>
        </>
      )}
    </section>
  );
}

/** The smallest distance of anything that moves to an obstacle or a zone, where there is one. */
function leastDistance({ least_distance_m, second_opinion }: PlanSummary): Fact[] {
  if (least_distance_m == null) return [];
  const pair = second_opinion?.closest.find(({ distance_m }) => distance_m === least_distance_m);
  const note = pair && betweenSaid(pair.first, pair.second);
  return [{ name: words.value.preview.least, value: spelt('length', least_distance_m), note }];
}

/** For how long the shown plan may be released: a shape that empties, and words. */
function Validity() {
  const said = words.value.preview;
  const left = offered_s.value;
  if (plan.value === null) return <p class="hint">{words.value.reading.title}</p>;
  return (
    <div class="validity" role="timer">
      <progress max={plan.value?.expires_s ?? 60} value={left} aria-label={said.valid} />
      <b>{left > 0 ? `${said.valid} ${clock(left)}` : said.expired}</b>
    </div>
  );
}

function Actions() {
  const said = words.value.preview;
  const shown = plan.value;
  if (shown === null || !may('operator')) return null;
  if (!mine.value) {
    const others = holder.value !== null;
    return others ? null : (
      <Press kind="primary" act={() => takeControl(cellOfRun())}>
        {words.value.bar.takeControl}
      </Press>
    );
  }
  if (offered_s.value === 0) {
    return (
      <Press kind="primary" act={() => showPlan(shown.run)}>
        {said.again}
      </Press>
    );
  }
  if (armed.value === null) {
    return (
      <Press
        kind="primary"
        act={() => {
          armed.value = shown;
        }}
      >
        {said.release}
      </Press>
    );
  }
  return (
    <>
      <Press kind="start" act={() => start(shown)}>
        <b>
          <span aria-hidden="true">▶</span> {said.start}
        </b>
        <small>{said.startWhat(clock(shown.plan.summary.robot_s))}</small>
      </Press>
      <Press
        act={() => {
          armed.value = null;
        }}
      >
        {said.back}
      </Press>
    </>
  );
}

function cellOfRun(): string {
  return run.value?.cell ?? '';
}

function next(): string {
  const said = words.value.preview;
  if (armed.value !== null) return said.armedNext;
  if (mine.value) return said.next;
  return holder.value === null ? said.needControl : said.watching(holder.value);
}

export const preview: Screen = { Page: Preview, Actions, next };
