import type { Sensor } from '../api';
import { Facts } from '../ui/facts';
import { number, type Quantity, scaleOf, spelt } from '../ui/units';
import { words } from '../words';
import type { Cell } from './cells';
import { sizeOf } from './shapes';

/** What a cell keeps to, what stands in it, what the robot can carry there, what its sensor can feel. */
export function CellFacts({ cell }: { cell: Cell }) {
  const said = words.value.cells;
  const { limits, obstacles = [], payloads = {} } = cell;
  return (
    <section class="cell-facts">
      <h2>{said.limits}</h2>
      <Facts
        facts={[
          { name: said.speed, value: spelt('speed', limits?.cartesian_speed_m_s ?? 0) },
          { name: said.clearance, value: spelt('length', limits?.clearance_m ?? 0) },
          { name: said.selfClearance, value: spelt('length', limits?.self_clearance_m ?? 0) },
          { name: said.floor, value: spelt('length', cell.floor_z_m ?? 0) },
        ]}
      />
      <h2>{said.obstacles}</h2>
      <Things all={obstacles.map(({ name, shape }) => [name, sizeOf(shape)])} />
      <h2>{said.payloads}</h2>
      <Things all={Object.values(payloads).map(({ title, mass_kg }) => [title, spelt('mass', mass_kg)])} />
      <h2>{`${said.sensor}: ${cell.sensor.name}`}</h2>
      <SensorFacts sensor={cell.sensor} />
    </section>
  );
}

function Things({ all }: { all: [string, string][] }) {
  if (all.length === 0) return <p>{words.value.cells.none}</p>;
  return (
    <ul class="things">
      {all.map(([name, note]) => (
        <li key={name}>
          <b>{name}</b> <small>{note}</small>
        </li>
      ))}
    </ul>
  );
}

function SensorFacts({ sensor }: { sensor: Sensor }) {
  const said = words.value.cells;
  const rows = [
    [said.range, sensor.range],
    [said.noise, sensor.noise_std],
    [said.resolution, sensor.resolution],
  ] as const;
  return (
    <Facts
      facts={rows.map(([name, six]) => ({
        name,
        value: three('force', six.slice(0, 3)),
        note: three('torque', six.slice(3)),
      }))}
    />
  );
}

/** Along x, y, z; once where all are alike. */
function three(quantity: Quantity, values: number[]): string {
  const { factor, unit } = scaleOf(quantity);
  const texts = values.map((value) => number(factor * value, placesOf(factor * value)));
  const alike = texts.every((text) => text === texts[0]);
  return `${(alike ? texts.slice(0, 1) : texts).join(' | ')} ${unit}`;
}

/** Decimals for two digits that count. */
function placesOf(value: number): number {
  return value === 0 ? 0 : Math.max(0, 1 - Math.floor(Math.log10(Math.abs(value))));
}
