import type { ComponentChildren } from 'preact';
import type { LogClock, LogColumns, LogUnderstood } from '../api';
import { Press } from '../ui/press';
import { number, scaled, spelt } from '../ui/units';
import { importWords } from './import-words';
import { answer } from './imports';

interface Row {
  name: string;
  value: ComponentChildren;
  note?: ComponentChildren;
}

const MOST_NAMED = 4;

/** What the columns of the log were taken for. */
export function Understood({ log }: { log: LogUnderstood }) {
  const said = importWords.value;
  return (
    <section class="stack">
      <h2>{said.understood}</h2>
      <table class="understood">
        <tbody>
          {[...rowsOfWrench(log), ...rowsOfMotion(log)].map(({ name, value, note }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>
                {value}
                {note && <small>{note}</small>}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function rowsOfWrench(log: LogUnderstood): Row[] {
  const said = importWords.value;
  const { rows_kept, rows_read, rows_repeated, rows_outside, mass_kg, clock } = log;
  const kept = whole(rows_kept);
  const leftOut = rows_repeated + rows_outside > 0;
  return [
    {
      name: said.rows,
      value:
        clock.time === null
          ? said.poses(kept)
          : said.kept(kept, whole(rows_read), number(log.rate_hz, 0), number(log.lasts_s, 1)),
      note: leftOut && said.leftOut(whole(rows_repeated), whole(rows_outside)),
    },
    ...rowsOfSensor(log),
    ...(mass_kg === null ? [] : [{ name: said.weight, value: spelt('mass', mass_kg, log.mass_std_kg) }]),
  ];
}

/** None where no wrist sensor is logged. */
function rowsOfSensor({ force, torque, sign, axes, clock, is_compensated }: LogUnderstood): Row[] {
  const said = importWords.value;
  if (force === null || torque === null || sign === null || axes === null) return [];
  return [
    { name: said.force, value: <Columns of={force} />, note: is_compensated && said.compensated },
    { name: said.torque, value: <Columns of={torque} />, note: timeOf(clock) },
    { name: said.signName, value: said.sign[sign], note: sign === -1 && said.turned },
    { name: said.axesName, value: said.axes[axes], note: axes === 'base' && said.turnedIn },
  ];
}

function rowsOfMotion(log: LogUnderstood): Row[] {
  const said = importWords.value;
  const notes = [log.is_inverse && said.inverse, timeOf(log.motion_clock)].filter(Boolean);
  const rows: Row[] = [
    { name: said.motion[log.motion], value: <Columns of={log.attitude} />, note: notes.join(' · ') },
  ];
  if (log.joint_torques !== null)
    rows.push({ name: said.jointTorques, value: <Columns of={log.joint_torques} /> });
  if (log.motion === 'joints')
    rows.push({ name: said.frames, value: `${log.base_frame} → ${log.sensor_frame}` });
  else
    rows.push({
      name: said.position,
      value: log.position === null ? said.noPosition : <Columns of={log.position} />,
    });
  if (log.motion_hz !== null) rows.push({ name: said.clocks, ...offsetOf(log) });
  return rows;
}

/** By how much the wrench is behind, and a button that takes it off. */
function offsetOf({ late_s, late_std_s, motion_hz, clock }: LogUnderstood): Omit<Row, 'name'> {
  const said = importWords.value;
  const rates = `${number(motion_hz ?? 0, 0)} Hz`;
  if (late_s === null) return { value: said.lateUnknown, note: rates };
  const { value, half } = scaled({ factor: 1e3, unit: 'ms', places: 1 }, late_s, late_std_s);
  const begins_s = clock.begins_s - late_s;
  return {
    value: said.late(half === null ? value : `${value} ± ${half}`),
    note: <Press act={() => answer('wrench.begins_s', String(begins_s))}>{said.takeOff}</Press>,
  };
}

function Columns({ of: { columns, unit } }: { of: LogColumns }) {
  const first = columns[0] ?? '';
  const shown = columns.length > MOST_NAMED ? `${first} … ${columns.at(-1)}` : columns.join(' ');
  return (
    <>
      <code>{shown}</code> {unit && `[${unit}]`}
    </>
  );
}

function timeOf({ file, time, unit, begins_s }: LogClock): string {
  const said = importWords.value;
  const shift = begins_s === 0 ? '' : ` + ${number(begins_s, 3)} s`;
  const clock = time === null ? '' : `${said.time}: ${time} [${unit}]${shift}`;
  return [file, clock].filter(Boolean).join(' · ');
}

const whole = (count: number) => number(count, 0);
