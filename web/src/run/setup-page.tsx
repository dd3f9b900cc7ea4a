import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { CellChoice } from '../cells/cell-choice';
import { CellFlaws } from '../cells/cell-flaws';
import { cell, chosenCell } from '../cells/cells';
import { shownCell } from '../cells/shown-cell';
import { TourOffer } from '../help/tour-offer';
import { may, session } from '../session/session';
import { SaveTool } from '../tools/save-tool';
import { ToolChoice } from '../tools/tool-choice';
import { Facts } from '../ui/facts';
import { Press } from '../ui/press';
import { go, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { spelt } from '../ui/units';
import { words } from '../words';
import { holder, mine, takeControl } from './control';
import { MoreSettings } from './more-settings';
import { box, type Field, mass_kg, order, tool, unfit } from './order';
import { activeRun, queueRun } from './runs';
import { ToolFields } from './tool-fields';
import { Viewer } from './viewer';

/** The field that somebody was led to; null where nobody was. */
const wantedField = signal<Field | null>(null);

/** Goes to where a run is set up, and there to one of its fields. */
export function goToField(field: Field): void {
  wantedField.value = field;
  go();
}

function showWantedField(): void {
  const found = document.getElementById(`field-${wantedField.value}`);
  wantedField.value = null;
  if (found === null) return;
  found.closest('details')?.setAttribute('open', '');
  found.scrollIntoView({ block: 'center' });
  found.querySelector<HTMLElement>('input, select')?.focus({ preventScroll: true });
}

function Setup() {
  const said = words.value.setup;
  useEffect(showWantedField, []);
  return (
    <div class="page setup">
      <Viewer cell={chosenCell.value} />
      <div class="setup-form">
        <TourOffer />
        <h1>{said.title}</h1>
        {shownCell.value && isFlawed() && (
          <section class="refused">
            <CellFlaws shown={shownCell.value} />
            <a class="download" href={to('cells', chosenCell.value)}>
              {words.value.cells.lookAtCell}
            </a>
          </section>
        )}
        <CellChoice
          legend={said.cell}
          chosen={chosenCell.value}
          choose={(value) => {
            chosenCell.value = value;
          }}
        />
        <div id="field-tool">
          <ToolChoice
            chosen={tool.value}
            choose={(name) => {
              tool.value = name;
            }}
          />
        </div>
        <ToolFields />
        {box.value && (
          <SaveTool
            label={said.saveTool}
            begin={() => ({
              cell: chosenCell.value,
              box: box.value ?? undefined,
              mass_kg: mass_kg.value,
            })}
            saved={({ name }) => {
              tool.value = name;
            }}
          />
        )}
        <MoreSettings />
        <CellFacts />
      </div>
    </div>
  );
}

function CellFacts() {
  const said = words.value.setup;
  const here = cell.value;
  if (here === null) return null;
  const names = (all: { name: string }[] | undefined) =>
    all?.map((each) => each.name).join(', ') || said.none;
  return (
    <section class="cell-facts">
      <h2>{said.about}</h2>
      <Facts
        facts={[
          { name: said.zones, value: names(here.zones) },
          { name: said.obstacles, value: names(here.obstacles) },
          { name: said.speed, value: spelt('speed', here.limits?.cartesian_speed_m_s ?? 0) },
          { name: said.clearance, value: spelt('length', here.limits?.clearance_m ?? 0) },
        ]}
      />
    </section>
  );
}

function Actions() {
  const said = words.value.setup;
  const active = activeRun.value;
  if (active !== null) {
    return (
      <Press kind="primary" act={() => go('runs', active.run)}>
        {said.open}
      </Press>
    );
  }
  if (!may('operator') || heldElsewhere() || isFlawed()) return null;
  return (
    <Press kind="primary" disabled={order.value === null} act={plan}>
      {mine.value ? said.planOnly : said.plan}
    </Press>
  );
}

/** Whether the cell as it is now leaves nothing to be planned. */
function isFlawed(): boolean {
  return (shownCell.value?.flaws.length ?? 0) > 0;
}

function heldElsewhere(): boolean {
  return holder.value !== null && holder.value !== session.value?.name;
}

async function plan(): Promise<void> {
  const asked = order.value;
  if (asked === null) return;
  if (!mine.value) await takeControl(asked.cell);
  go('runs', (await queueRun(asked)).run);
}

function next(): string {
  const said = words.value.setup;
  if (activeRun.value !== null) return said.running;
  if (!may('operator')) return said.mayNot;
  if (isFlawed()) return words.value.cells.nextFlawed;
  if (unfit.value !== null) return words.value.refusal.correct[unfit.value];
  return heldElsewhere() ? said.busy(holder.value ?? '') : said.next;
}

export const setup: Screen = { Page: Setup, Actions, next };
