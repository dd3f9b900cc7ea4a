import type { Also, Remark } from '../api';
import { NARROW_SPACE, number } from '../ui/units';
import { words } from '../words';
import type { Named } from '../words/en-remarks';

/** A remark of the engine in the chosen language; undefined where its catalogue has no words for it. */
export function remarkSaid({ id, values }: Remark): string | undefined {
  return words.value.remarks.warnings[id]?.(named(values));
}

/** What was seen elsewhere than in the wrench, likewise. */
export function seenSaid({ remark, values }: Also): string | undefined {
  return words.value.gap.seen[remark]?.(named(values));
}

function named(values: Remark['values']): Named {
  return Object.fromEntries(Object.entries(values ?? {}).map(([name, value]) => [name, text(name, value)]));
}

const seconds = (value: number) =>
  value < 1 ? `${number(1e3 * value, 1)}${NARROW_SPACE}ms` : `${number(value, 1)}${NARROW_SPACE}s`;

/** As many places as show three digits. */
function threeDigits(value: number): string {
  const size = Math.abs(value);
  return number(value, size > 0 ? Math.max(0, 2 - Math.floor(Math.log10(size))) : 0);
}

/** In degrees, or in what is left to see where they would be none. */
function angle(value: number): string {
  if (Math.abs(value) < SMALLEST_RAD) return `${threeDigits(1e3 * value)}${NARROW_SPACE}mrad`;
  return `${number((180 / Math.PI) * value, 2)}°`;
}

/** Half of a hundredth of a degree. */
const SMALLEST_RAD = 1e-4;
const UNITS: Record<string, string> = { n: 'N', nm: 'N m', nms: 'N m s/rad', hz: 'Hz' };

/** The unit of a number stands in its name. */
function text(name: string, value: number | string): string {
  if (typeof value === 'string') return value;
  if (name.endsWith('_rad')) return angle(value);
  if (name.endsWith('_s')) return seconds(value);
  if (name.endsWith('_share')) return `${number(100 * value, 1)}${NARROW_SPACE}%`;
  const unit = UNITS[name.slice(name.lastIndexOf('_') + 1)];
  if (unit !== undefined) return `${threeDigits(value)}${NARROW_SPACE}${unit}`;
  return number(value, 1);
}
