import { adminWords } from './admin-words';

/** What the service holds passwords and names to (`server/http/schemas.py`). */
export const SHORTEST_PASSWORD = 12;
const NAME = /^[A-Za-z0-9_-]{1,64}$/;

/** What is wrong with a new name; null where nothing is. `empty` counts as wrong as well, but is no flaw yet. */
export function nameFlaw(name: string, others: string[], taken: string): string | null {
  const said = adminWords.value.people;
  if (name === '') return null;
  if (!NAME.test(name)) return said.badName;
  return others.includes(name) ? taken : null;
}

/** What is missing from a new password; null where nothing is. */
export function passwordLacking(password: string): string | null {
  const missing = SHORTEST_PASSWORD - password.length;
  return missing > 0 ? adminWords.value.account.tooShort(missing) : null;
}
