import type { CellValues, DraftCellPublic, JointValues, Sensor } from '../api';
import { scaleOf, typed } from '../ui/units';

type Edits = Record<string, string>;
export const LIMITS = [
  'lower_rad',
  'upper_rad',
  'velocity_rad_s',
  'effort_n_m',
  'acceleration_rad_s2',
] as const;
export const SIX = ['range', 'noise_std', 'resolution'] as const;
const DEGREES = 180 / Math.PI;
/** What a sensor is called in a cell whose sensor nobody has stated. */
const NOT_STATED = 'not stated';

/** What was typed for a value, in SI; null where nothing was, or nothing that can be read. */
function read(edits: Edits, name: string, factor = 1): number | null {
  const found = typed(edits[name] ?? '');
  return found === null ? null : found / factor;
}

/** What was typed, in the place of what was made. */
function readEach(edits: Edits, names: string[], values: number[], factor = 1): number[] {
  return names.map((name, k) => read(edits, name, factor) ?? values[k] ?? 0);
}

const isTyped = (edits: Edits, beginning: string) =>
  Object.entries(edits).some(([name, text]) => name.startsWith(beginning) && text.trim() !== '');

const three = (name: string) => ['x', 'y', 'z'].map((axis) => `${name}.${axis}`);
const six = (name: string) => Array.from({ length: 6 }, (_, k) => `${name}.${k}`);

/** All that somebody knows better than the description, as the service takes it. */
export function valuesOf(title: string, edits: Edits, made: DraftCellPublic | null): CellValues {
  const values: CellValues = { title: title.trim() || null };
  if (made === null) return values;
  const { cell } = made;
  const length = scaleOf('length').factor;
  const home = made.joints.map((_, k) => `home.${k}`);
  const limits = cell.limits ?? {};
  return {
    ...values,
    joints: jointsOf(edits, made),
    masses_kg: massesOf(edits, made),
    friction: frictionOf(edits, made),
    home_rad: isTyped(edits, 'home.') ? readEach(edits, home, cell.robot.home_rad) : null,
    sensor: sensorOf(edits, cell.sensor),
    floor_z_m: read(edits, 'floor', length),
    payload_box: isTyped(edits, 'box.') ? boxOf(edits, cell.payload_box) : null,
    limits: {
      cartesian_speed_m_s:
        read(edits, 'speed', scaleOf('speed').factor) ?? limits.cartesian_speed_m_s ?? 0.25,
      clearance_m: read(edits, 'clearance', length) ?? limits.clearance_m ?? 0.03,
      self_clearance_m: read(edits, 'selfClearance', length) ?? limits.self_clearance_m ?? 0.01,
    },
  };
}

function jointsOf(edits: Edits, { joints }: DraftCellPublic): Record<string, JointValues> {
  const typedJoints = joints.map(({ name }): [string, JointValues] => [
    name,
    Object.fromEntries(
      LIMITS.flatMap((key) => {
        const value = read(edits, `joint.${name}.${key}`);
        return value === null ? [] : [[key, value]];
      }),
    ),
  ]);
  return Object.fromEntries(typedJoints.filter(([, values]) => Object.keys(values).length > 0));
}

function massesOf(edits: Edits, { links }: DraftCellPublic): Record<string, number> {
  const { factor } = scaleOf('mass');
  return Object.fromEntries(
    links.flatMap(({ name }) => {
      const mass_kg = read(edits, `mass.${name}`, factor);
      return mass_kg === null ? [] : [[name, mass_kg]];
    }),
  );
}

function frictionOf(edits: Edits, { joints }: DraftCellPublic): NonNullable<CellValues['friction']> | null {
  if (!isTyped(edits, 'friction.')) return null;
  const each = (kind: string) => joints.map(({ name }) => read(edits, `friction.${name}.${kind}`) ?? 0);
  return { coulomb_n_m: each('coulomb'), viscous_n_m_s: each('viscous') };
}

type Six = Sensor['range'];

function sensorOf(edits: Edits, made: Sensor): NonNullable<CellValues['sensor']> | null {
  if (!isTyped(edits, 'sensor.')) return null;
  const [range, noise_std, resolution] = SIX.map((key) =>
    readEach(edits, six(`sensor.${key}`), made[key]),
  ) as [Six, Six, Six];
  const known = made.name.startsWith(NOT_STATED) ? '' : made.name;
  const mount = isTyped(edits, 'sensor.mount')
    ? {
        xyz_m: readEach(edits, three('sensor.mount'), made.mount?.xyz_m ?? [], scaleOf('length').factor),
        rpy_rad: readEach(edits, three('sensor.mountTurn'), made.mount?.rpy_rad ?? [], DEGREES),
      }
    : null;
  return {
    name: edits['sensor.name']?.trim() || known,
    range,
    noise_std,
    resolution,
    mount: mount as Sensor['mount'] & object,
  };
}

function boxOf(
  edits: Edits,
  made: NonNullable<DraftCellPublic['cell']['payload_box']>,
): NonNullable<CellValues['payload_box']> | null {
  const length = scaleOf('length').factor;
  const size_m = readEach(edits, three('box.size'), made.size_m, length) as [number, number, number];
  const xyz_m = readEach(edits, three('box.centre'), made.pose?.xyz_m ?? [], length) as [
    number,
    number,
    number,
  ];
  return { kind: 'box', size_m, pose: { ...made.pose, xyz_m } };
}

/** Whether figures of the sensor stand there, and not what it is. */
export function lacksSensorName(edits: Edits, made: DraftCellPublic | null): boolean {
  if (!isTyped(edits, 'sensor.') || edits['sensor.name']?.trim()) return false;
  return edits['sensor.name'] !== undefined || (made?.cell.sensor.name.startsWith(NOT_STATED) ?? true);
}
