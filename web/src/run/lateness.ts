import type { RunPublic } from '../api';
import { seconds } from '../ui/units';
import { words } from '../words';
import { mine } from './control';

/** What was late, by how much, against which limit, in one sentence; null where nothing was. */
export function latenessSaid({ lateness, state }: RunPublic): string | null {
  if (lateness === null) return null;
  const said = words.value.held;
  const what = said.late[lateness.cause](mine.value, seconds(lateness.late_s), seconds(lateness.limit_s));
  return `${what} ${state === 'Held' || state === 'Holding' ? said.keepsPlace : said.stopped}`;
}
