import { computed, effect, signal } from '@preact/signals';
import type { RunOrder } from '../api';
import { cell, payloads } from '../cells/cells';
import { units } from '../session/settings';
import { NARROW_SPACE, number, scaleOf, typed } from '../ui/units';

/** Slower than this a transfer takes minutes; the service refuses it. */
const SLOWEST_M_S = 0.01;

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

export const payload = computed(() => payloads.value.find(([name]) => name === tool.value)?.[1] ?? null);
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
function written(value: number, quantity: 'mass' | 'length'): string {
  const { factor, places } = scaleOf(quantity);
  return number(factor * value, places).replaceAll(NARROW_SPACE, '');
}

effect(() => {
  const known = payloads.value.map(([name]) => name);
  if (!known.includes(tool.peek())) tool.value = known[0] ?? '';
});
effect(() => {
  const chosen = payload.value;
  if (chosen === null || !units.value) return;
  const [x, y, z] = chosen.box.size_m;
  size.value = [written(x, 'length'), written(y, 'length'), written(z, 'length')];
  mass.value = written(chosen.mass_kg, 'mass');
});

/** What is to be identified, as the fields say; null while they cannot be read. */
export const order = computed<RunOrder | null>(() => {
  const [x, y, z] = size_m.value;
  const chosen = payload.value;
  if (cell.value === null || chosen === null || mass_kg.value === null || !x || !y || !z) return null;
  if (axes.value === '' || Number.isNaN(speed_m_s.value)) return null;
  const [px = 0, py = 0] = chosen.box.pose?.xyz_m ?? [];
  const pose = { xyz_m: [px, py, z / 2] as [number, number, number] };
  const edited = [x, y, z].some((length, k) => Math.abs(length - (chosen.box.size_m[k] ?? 0)) > 1e-4);
  const payload_box = edited
    ? { kind: 'box' as const, size_m: [x, y, z] as [number, number, number], pose }
    : null;
  return {
    cell: cell.value.name,
    payload: tool.value,
    payload_box,
    mass_guess_kg: mass_kg.value,
    axes: axes.value,
    rotations: rotations.value,
    speed_m_s: speed_m_s.value,
    effort: effort.value,
  };
});
