import { cell } from '../cells/cells';
import { NumberField } from '../ui/number-field';
import { Select } from '../ui/select';
import { scaleOf, spelt } from '../ui/units';
import { words } from '../words';
import { axes, effort, rotations, SLOWEST_M_S, speed, speed_m_s, untilRequired } from './order';

const AXES = ['x', 'y', 'z'];
const EFFORTS = [1, 2, 4, 8, 16];

/** What few people change of a run: folded away until it is wanted. */
export function MoreSettings() {
  const said = words.value.setup;
  const limit = spelt('speed', cell.value?.limits?.cartesian_speed_m_s ?? 0);
  const badSpeed = cell.value !== null && Number.isNaN(speed_m_s.value);
  return (
    <details class="others more-settings">
      <summary>{said.more}</summary>
      <fieldset id="field-axes">
        <legend>{said.axes}</legend>
        <div class="three">
          {AXES.map((axis) => (
            <label key={axis}>
              <input type="checkbox" checked={axes.value.includes(axis)} onChange={() => toggle(axis)} />
              <span>{axis}</span>
            </label>
          ))}
        </div>
        <p class={axes.value === '' ? 'hint flaw' : 'hint'}>
          {axes.value === '' ? said.noAxis : said.axesHint}
        </p>
      </fieldset>
      <fieldset>
        <legend>{said.rotations}</legend>
        <label>
          <input
            type="checkbox"
            checked={rotations.value}
            onChange={({ currentTarget }) => {
              rotations.value = currentTarget.checked;
            }}
          />
          <span>{said.turn}</span>
        </label>
        <p class="hint">{said.rotationsHint}</p>
      </fieldset>
      <fieldset>
        <legend>{said.target}</legend>
        <label>
          <input
            type="checkbox"
            checked={untilRequired.value}
            onChange={({ currentTarget }) => {
              untilRequired.value = currentTarget.checked;
            }}
          />
          <span>{said.untilRequired}</span>
        </label>
        <p class="hint">{said.targetHint}</p>
      </fieldset>
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

function toggle(axis: string): void {
  const now = axes.value;
  axes.value = AXES.filter((each) => now.includes(each) !== (each === axis)).join('');
}
