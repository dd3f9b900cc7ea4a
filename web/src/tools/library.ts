import { effect, signal } from '@preact/signals';
import type { PayloadPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { spelt } from '../ui/units';

/** Another screen may have saved a tool meanwhile. */
const ASK_MS = 30_000;
const RETRY_MS = 1000;

/** What operators call a tool the service calls a payload: those of the chosen cell, by title; null until they are known. */
export const library = signal<PayloadPublic[] | null>(null);

export async function readLibrary(): Promise<void> {
  const cell = chosenCell.value;
  const found = await ask('GET /api/cells/{cell}/payloads', { path: { cell } });
  if (chosenCell.value === cell) library.value = found;
}

/** About how heavy a tool is, kg: as it is known, else the middle of what is expected; null where nobody has said. */
export function expectedMass({ reference, mass_least_kg, mass_most_kg }: PayloadPublic): number | null {
  if (reference) return reference.mass_kg;
  const known = [mass_least_kg, mass_most_kg].filter((each) => each != null);
  return known.length === 0 ? null : known.reduce((sum, each) => sum + each, 0) / known.length;
}

/** The range in which a tool's mass should be, in words; null where nobody has said. */
export function massRange({ mass_least_kg, mass_most_kg }: PayloadPublic): string | null {
  if (mass_least_kg != null && mass_most_kg != null)
    return `${spelt('mass', mass_least_kg)} – ${spelt('mass', mass_most_kg)}`;
  if (mass_least_kg != null) return `≥ ${spelt('mass', mass_least_kg)}`;
  return mass_most_kg == null ? null : `≤ ${spelt('mass', mass_most_kg)}`;
}

/** Whether a mass, kg, is outside of the range in which it should be. */
export function isUnexpected({ mass_least_kg, mass_most_kg }: PayloadPublic, mass_kg: number): boolean {
  return mass_kg < (mass_least_kg ?? 0) || mass_kg > (mass_most_kg ?? Number.POSITIVE_INFINITY);
}

/** Whether a tool contains every word that is searched for. */
export function containsWords({ title, name, note }: PayloadPublic, search: string): boolean {
  const text = [title, name, note].join(' ').toLocaleLowerCase();
  const wanted = search.toLocaleLowerCase().split(/\s+/).filter(Boolean);
  return wanted.every((word) => text.includes(word));
}

effect(() => {
  const cell = chosenCell.value;
  library.value = null;
  return session.value && cell ? every(ASK_MS, readLibrary, RETRY_MS) : undefined;
});
