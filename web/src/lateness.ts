import type { RunAnswer } from './api';
import { mine } from './stores/control';
import { seconds } from './units';
import { words } from './words';

/** What was late, by how much, against which limit, in one sentence; null where nothing was. */
export function latenessSaid({ lateness, state }: RunAnswer): string | null {
  if (lateness === null) return null;
  const said = words.value.held;
  const what = said.late[lateness.cause](mine.value, seconds(lateness.late_s), seconds(lateness.limit_s));
  return `${what} ${state === 'Held' || state === 'Holding' ? said.keepsPlace : said.stopped}`;
}
