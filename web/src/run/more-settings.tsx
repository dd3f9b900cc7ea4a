import type { Signal } from '@preact/signals';
import { cell } from '../cells/cells';
import { NumberField } from '../ui/number-field';
import { Select } from '../ui/select';
import { moment, scaleOf, spelt } from '../ui/units';
import { words } from '../words';
import {
  axes,
  effort,
  empty,
  evidence,
  rotations,
  SLOWEST_M_S,
  speed,
  speed_m_s,
  untilRequired,
  without,
} from './order';
import { runs } from './runs';

const AXES = ['x', 'y', 'z'];
const EVIDENCE = ['wrist_sensor', 'joint_torques'] as const;
const EFFORTS = [1, 2, 4, 8, 16];

/** What few people change of a run: folded away until it is wanted. */
export function MoreSettings() {
  const said = words.value.setup;
  const limit = spelt('speed', cell.value?.limits?.cartesian_speed_m_s ?? 0);
  const badSpeed = cell.value !== null && Number.isNaN(speed_m_s.value);
  return (
    <details class="others more-settings">
      <summary>{said.more}</summary>
      <div class="evidence">
        <Select
          label={said.evidence}
          options={EVIDENCE.map((each) => [each, said.evidences[each]])}
          chosen={evidence.value}
          choose={(chosen) => {
            evidence.value = EVIDENCE.find((each) => each === chosen) ?? 'wrist_sensor';
          }}
        />
        <Tick label={said.empty} chosen={empty} />
        <ComparedRun />
        <p class="hint">{said.evidenceHint}</p>
      </div>
      <fieldset id="field-axes">
        <legend>{said.axes}</legend>
        <div class="three">
          {AXES.map((axis) => (
            <label key={axis} class="option">
              <input type="checkbox" checked={axes.value.includes(axis)} onChange={() => toggle(axis)} />
              <span>{axis}</span>
            </label>
          ))}
        </div>
        <p class={axes.value === '' ? 'hint flaw' : 'hint'}>
          {axes.value === '' ? said.noAxis : said.axesHint}
        </p>
      </fieldset>
      {evidence.value === 'wrist_sensor' && (
        <>
          <fieldset>
            <legend>{said.rotations}</legend>
            <Tick label={said.turn} chosen={rotations} />
            <p class="hint">{said.rotationsHint}</p>
          </fieldset>
          <fieldset>
            <legend>{said.target}</legend>
            <Tick label={said.untilRequired} chosen={untilRequired} />
            <p class="hint">{said.targetHint}</p>
          </fieldset>
        </>
      )}
      <fieldset id="field-speed">
        <legend>
          {said.slower}, {scaleOf('speed').unit}
        </legend>
        <NumberField
          label={said.slower}
          hidden
          text={speed.value}
          flaw={badSpeed}
          change={(text) => {
            speed.value = text;
          }}
        />
        <p class={badSpeed ? 'hint flaw' : 'hint'}>
          {badSpeed
            ? words.value.refusal.badSpeed(spelt('speed', SLOWEST_M_S), limit)
            : said.slowerHint(limit)}
        </p>
      </fieldset>
      <fieldset id="field-effort">
        <legend>{said.effort}</legend>
        <Select
          label={said.effortTimes}
          options={EFFORTS.map((times) => [`${times}`, `${times} ×`])}
          chosen={`${effort.value}`}
          choose={(times) => {
            effort.value = Number(times);
          }}
        />
        <p class="hint">{said.effortHint}</p>
      </fieldset>
    </details>
  );
}

/** The run without the payload that the joints' torques are compared with, where there is one in this cell. */
function ComparedRun() {
  const known = (runs.value ?? []).filter((run) => run.order.empty && run.outcome === 'completed');
  if (evidence.value === 'wrist_sensor' || empty.value || known.length === 0) return null;
  const said = words.value.setup;
  return (
    <Select
      label={said.compared}
      options={[
        ['', said.none],
        ...known.map((run): [string, string] => [run.run, moment(run.requested_at)]),
      ]}
      chosen={without.value}
      choose={(run) => {
        without.value = run;
      }}
    />
  );
}

function Tick({ label, chosen }: { label: string; chosen: Signal<boolean> }) {
  return (
    <label class="option">
      <input
        type="checkbox"
        checked={chosen.value}
        onChange={({ currentTarget }) => {
          chosen.value = currentTarget.checked;
        }}
      />
      <span>{label}</span>
    </label>
  );
}

function toggle(axis: string): void {
  const now = axes.value;
  axes.value = AXES.filter((each) => now.includes(each) !== (each === axis)).join('');
}
