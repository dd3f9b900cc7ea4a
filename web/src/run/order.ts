import { computed, effect, signal } from '@preact/signals';
import type { Box, RunCreate, RunOrder } from '../api';
import { cell } from '../cells/cells';
import { units } from '../session/settings';
import { expectedMass, library } from '../tools/library';
import { NARROW_SPACE, number, scaleOf, typed } from '../ui/units';

/** Slower than this a transfer takes minutes; the service refuses it. */
export const SLOWEST_M_S = 0.01;

/** Name of the tool on the robot, as the cell knows it. */
export const tool = signal('');
/** Its bounding box and mass as they stand in the fields, in the chosen units. */
export const size = signal<[string, string, string]>(['', '', '']);
export const mass = signal('');
/** What few people change: sensor axes, rotations about them, a lower speed ('' for the cell's), times the usual search. */
export const axes = signal('xyz');
export const rotations = signal(true);
export const speed = signal('');
export const effort = signal(1);
/** What the payload is to be identified from, and whether it is off. */
export const evidence = signal<NonNullable<RunCreate['identify_from']>>('wrist_sensor');
export const empty = signal(false);
/** The run without the payload that this one is compared with; '' for none. */
export const without = signal('');
/** Whether the run ends as soon as the cell's requirement is met. */
export const untilRequired = signal(false);

/** Of two of one name that of cell.toml, as for every order. */
export const payload = computed(() => {
  const named = (library.value ?? []).filter(({ name }) => name === tool.value);
  return named.find(({ id }) => id === null) ?? named[0] ?? null;
});
/** SI; null where a field cannot be read. */
export const mass_kg = computed(() => read(mass.value, 'mass'));
/** null where nothing is written, NaN where it cannot be read or is above the cell's limit. */
export const speed_m_s = computed(() => {
  if (speed.value.trim() === '') return null;
  const found = read(speed.value, 'speed');
  const limit = cell.value?.limits?.cartesian_speed_m_s ?? 0;
  return found !== null && found >= SLOWEST_M_S && found <= limit ? found : Number.NaN;
});
export const size_m = computed(() => size.value.map((text) => read(text, 'length')));

function read(text: string, quantity: 'mass' | 'length' | 'speed'): number | null {
  const found = typed(text);
  return found === null || found <= 0 ? null : found / scaleOf(quantity).factor;
}

/** As `typed` reads it: without the spaces that group digits. */
function written(value: number, quantity: 'mass' | 'length' | 'speed'): string {
  const { factor, places } = scaleOf(quantity);
  return number(factor * value, places).replaceAll(NARROW_SPACE, '');
}

effect(() => {
  const known = (library.value ?? []).map(({ name }) => name);
  if (library.value === null || cell.value === null || known.includes(tool.peek())) return;
  tool.value = Object.keys(cell.value.payloads ?? {})[0] ?? known[0] ?? '';
});
const cellName = computed(() => cell.value?.name);
effect(() => {
  if (cellName.value) without.value = ''; // it is a run of another cell
});
/** What the chosen tool puts into the fields; the library is read again and again, and what is typed meanwhile stays. */
const chosenFields = computed(() => {
  const chosen = payload.value;
  return chosen && JSON.stringify([chosen.cell, chosen.name, chosen.box.size_m, expectedMass(chosen)]);
});
effect(() => {
  if (chosenFields.value === null || !units.value) return;
  const chosen = payload.peek();
  if (chosen === null) return;
  const [x, y, z] = chosen.box.size_m;
  const mass_kg = expectedMass(chosen);
  size.value = [written(x, 'length'), written(y, 'length'), written(z, 'length')];
  mass.value = mass_kg === null ? '' : written(mass_kg, 'mass');
});

/** The tool's box as the fields say it, sensor frame, and whether it is another one than the cell knows; null while they cannot be read. */
const typed_box = computed<{ box: Box; edited: boolean } | null>(() => {
  const [x, y, z] = size_m.value;
  const chosen = payload.value?.box;
  if (!chosen || !x || !y || !z) return null;
  const edited = [x, y, z].some((length, k) => Math.abs(length - (chosen.size_m[k] ?? 0)) > 1e-4);
  const [px = 0, py = 0] = chosen.pose?.xyz_m ?? [];
  const box = { kind: 'box' as const, size_m: [x, y, z] as [number, number, number] };
  return edited ? { box: { ...box, pose: { xyz_m: [px, py, z / 2] } }, edited } : { box: chosen, edited };
});
export const box = computed<Box | null>(() => typed_box.value?.box ?? null);

export type Field = 'box' | 'tool' | 'axes' | 'speed' | 'effort' | 'mass';

/** What keeps the fields from being an order; null where nothing does. */
export const unfit = computed<'cell' | 'box' | 'mass' | 'axes' | 'speed' | null>(() => {
  if (cell.value === null || payload.value === null) return 'cell';
  if (typed_box.value === null) return 'box';
  if (mass_kg.value === null) return 'mass';
  if (axes.value === '') return 'axes';
  return Number.isNaN(speed_m_s.value) ? 'speed' : null;
});

/** Puts into the fields what a run was asked for with. */
export function takeOrder(asked: RunOrder): void {
  tool.value = asked.payload ?? tool.value;
  const [x, y, z] = asked.payload_box?.size_m ?? payload.value?.box.size_m ?? [];
  if (x && y && z) size.value = [written(x, 'length'), written(y, 'length'), written(z, 'length')];
  if (asked.mass_guess_kg) mass.value = written(asked.mass_guess_kg, 'mass');
  axes.value = asked.axes ?? axes.value;
  rotations.value = asked.rotations ?? rotations.value;
  speed.value = asked.speed_m_s == null ? '' : written(asked.speed_m_s, 'speed');
  effort.value = asked.effort ?? effort.value;
  untilRequired.value = asked.target?.requirement ?? false;
  evidence.value = asked.identify_from ?? 'wrist_sensor';
  empty.value = asked.empty ?? false;
  without.value = asked.without ?? '';
}

/** What is to be identified, as the fields say; null while they cannot be read. */
export const order = computed<RunCreate | null>(() => {
  if (unfit.value !== null || cell.value === null || mass_kg.value === null) return null;
  const whole = evidence.value === 'joint_torques'; // what the joints are to feel is no rotation, and is made to its end
  return {
    cell: cell.value.name,
    payload: tool.value,
    payload_box: typed_box.value?.edited ? typed_box.value.box : null,
    mass_guess_kg: mass_kg.value,
    axes: axes.value,
    identify_from: evidence.value,
    empty: empty.value,
    without: (whole && !empty.value && without.value) || null,
    rotations: whole || rotations.value,
    speed_m_s: speed_m_s.value,
    effort: effort.value,
    target: untilRequired.value && !whole ? { requirement: true } : null,
  };
});
