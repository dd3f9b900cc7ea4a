import { computed, effect, signal } from '@preact/signals';
import type { DiagnosisPublic, TwinPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { route } from '../ui/route';
import { diagnosis } from './diagnoses';

/** What the twin of the shown cell has; null until it is known. */
export const twin = signal<TwinPublic | null>(null);

const watched = computed(() => (route.value[0] === 'gap' ? cellOf(diagnosis.value) : null));

/** The cell whose twin is looked at: that of the shown diagnosis, or the one that this console stands at. */
export function cellOf(shown: DiagnosisPublic | null): string | null {
  return shown === null ? chosenCell.value || null : shown.cell;
}

/** Adds an effect, or two joined by a plus sign, to a cell's twin as a diagnosis found it. */
export async function addEffect(cell: string, diagnosis: string, effect: string): Promise<void> {
  show(cell, await ask('POST /api/cells/{cell}/twin', { path: { cell }, body: { diagnosis, effect } }));
}

export async function removeEffect(cell: string, effect: string): Promise<void> {
  show(cell, await ask('DELETE /api/cells/{cell}/twin/{effect}', { path: { cell, effect } }));
}

/** Whether the twin has an effect, or both of two, from the recording of this diagnosis. */
export function isAdded({ result }: DiagnosisPublic, effect: string): boolean {
  const from = twin.value?.effects?.filter(({ sha256 }) => sha256 === result?.origin?.sha256) ?? [];
  return effect.split('+').every((id) => from.some((entry) => entry.effect === id));
}

function show(cell: string, found: TwinPublic): void {
  if (watched.value === cell) twin.value = found;
}

effect(() => {
  const cell = watched.value;
  twin.value = null;
  if (!session.value || cell === null) return undefined;
  return until(async () => show(cell, await ask('GET /api/cells/{cell}/twin', { path: { cell } })));
});
