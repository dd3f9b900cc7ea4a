import { number } from '../ui/units';

/** A time as long as a network takes. */
export function milliseconds(time_s: number): string {
  return `${number(1000 * time_s, 0)} ms`;
}
