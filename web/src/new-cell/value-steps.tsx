import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { scaleOf } from '../ui/units';
import { edit, edits, hasUnread, made, remake } from './draft';
import { newCellWords } from './new-cell-words';
import { PairChoice } from './pair-choice';
import { Said } from './said';
import { ThreeFields, ValueField } from './value-field';
import { lacksSensorName, SIX } from './values';

const DEGREES = 180 / Math.PI;

/** Where every run begins and ends. */
export function HomeStep() {
  const said = newCellWords.value.home;
  const { joints = [], cell } = made.value ?? {};
  return (
    <>
      <fieldset>
        <legend>{said.legend}</legend>
        <div class="five">
          {joints.map(({ name }, k) => (
            <ValueField key={name} name={`home.${k}`} label={name} value={cell?.robot.home_rad[k]} />
          ))}
        </div>
      </fieldset>
      <div>
        <Press disabled={hasUnread.value} act={remake}>
          {said.show}
        </Press>
      </div>
      <Said step="home" />
    </>
  );
}

/** What measures: its figures stand behind every interval. */
export function SensorStep() {
  const said = newCellWords.value.sensor;
  const sensor = made.value?.cell.sensor;
  const stated = sensor && !sensor.name.startsWith('not stated') ? sensor.name : '';
  const titles = { range: said.range, noise_std: said.noise, resolution: said.resolution };
  const { factor, unit } = scaleOf('length');
  return (
    <>
      <TextField
        label={said.name}
        hint={said.nameHint}
        flaw={lacksSensorName(edits.value, made.value) ? said.lackName : null}
        text={edits.value['sensor.name'] ?? stated}
        change={(text) => edit('sensor.name', text)}
      />
      {SIX.map((key) => (
        <fieldset key={key}>
          <legend>{titles[key]}</legend>
          {[said.force, said.torque].map((label, half) => (
            <div key={label}>
              <small>{label}</small>
              <div class="three">
                {[0, 1, 2].map((k) => (
                  <ValueField
                    key={k}
                    name={`sensor.${key}.${3 * half + k}`}
                    label={`${titles[key]}, ${label}: ${'xyz'[k]}`}
                    hidden
                    value={sensor?.[key][3 * half + k]}
                  />
                ))}
              </div>
            </div>
          ))}
        </fieldset>
      ))}
      <ThreeFields
        name="sensor.mount"
        legend={said.mount(unit)}
        values={sensor?.mount?.xyz_m}
        factor={factor}
      />
      <ThreeFields
        name="sensor.mountTurn"
        legend={said.mountTurn}
        values={sensor?.mount?.rpy_rad}
        factor={DEGREES}
        places={2}
      />
      <p class="hint">{said.mountHint}</p>
      <Said step="sensor" />
    </>
  );
}

/** The room around the robot: floor, payload, speed and clearances. */
export function RoomStep() {
  const said = newCellWords.value.room;
  const cell = made.value?.cell;
  const length = scaleOf('length');
  const speed = scaleOf('speed');
  const { factor } = length;
  return (
    <>
      <ValueField name="floor" label={said.floor(length.unit)} value={cell?.floor_z_m} factor={factor} />
      <ThreeFields
        name="box.size"
        legend={said.size(length.unit)}
        values={cell?.payload_box.size_m}
        factor={factor}
      />
      <ThreeFields
        name="box.centre"
        legend={said.centre(length.unit)}
        values={cell?.payload_box.pose?.xyz_m}
        factor={factor}
      />
      <ValueField
        name="speed"
        label={said.speed(speed.unit)}
        value={cell?.limits?.cartesian_speed_m_s}
        factor={speed.factor}
      />
      <ValueField
        name="clearance"
        label={said.clearance(length.unit)}
        value={cell?.limits?.clearance_m}
        factor={factor}
      />
      <ValueField
        name="selfClearance"
        label={said.selfClearance(length.unit)}
        value={cell?.limits?.self_clearance_m}
        factor={factor}
      />
      <PairChoice />
      <Said step="room" />
    </>
  );
}
