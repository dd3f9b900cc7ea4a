import type { Remark } from './api';
import { NARROW_SPACE, number } from './units';
import { words } from './words';
import type { Named } from './words/en-remarks';

/** A remark of the engine in the chosen language; undefined where its catalogue has no words for it. */
export function remarkSaid({ id, values }: Remark): string | undefined {
  return words.value.remarks.warnings[id]?.(named(values));
}

function named(values: Remark['values']): Named {
  return Object.fromEntries(Object.entries(values ?? {}).map(([name, value]) => [name, text(name, value)]));
}

const seconds = (value: number) =>
  value < 1 ? `${number(1e3 * value, 1)}${NARROW_SPACE}ms` : `${number(value, 1)}${NARROW_SPACE}s`;

/** The unit of a number stands in its name. */
function text(name: string, value: number | string): string {
  if (typeof value === 'string') return value;
  if (name.endsWith('_rad')) return `${number((180 / Math.PI) * value, 2)}°`;
  if (name.endsWith('_s')) return seconds(value);
  return number(value, 1);
}
