import { computed, effect, signal } from '@preact/signals';
import type { AdditionAnswer, DiagnosisAnswer, TwinAnswer } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { ASK_JOB_MS, isUnderWay } from '../ui/jobs';
import { route } from '../ui/route';
import { diagnosis } from './diagnoses';

const ASK_TWIN_MS = 3000;

/** What the twin of the shown cell has; null until it is known. */
export const twin = signal<TwinAnswer | null>(null);
/** The addition that was asked for last. */
export const addition = signal<AdditionAnswer | null>(null);

const watched = computed(() => (route.value[0] === 'gap' ? cellOf(diagnosis.value) : null));

/** The cell whose twin is looked at: that of the shown diagnosis, or the one that this console stands at. */
export function cellOf(shown: DiagnosisAnswer | null): string | null {
  return shown === null ? chosenCell.value || null : shown.cell;
}

/** Asks for an effect, or two joined by a plus sign, to be added to a cell's twin. */
export async function addEffect(cell: string, diagnosis: string, effect: string): Promise<void> {
  addition.value = await ask('POST /api/cells/{cell}/twin', { path: { cell }, body: { diagnosis, effect } });
}

export async function cancelAddition({ cell, addition: id }: AdditionAnswer): Promise<void> {
  const path = { cell, addition: id };
  addition.value = await ask('DELETE /api/cells/{cell}/twin/additions/{addition}', { path });
}

export async function removeEffect(cell: string, effect: string): Promise<void> {
  twin.value = await ask('DELETE /api/cells/{cell}/twin/{effect}', { path: { cell, effect } });
}

async function readTwin(cell: string): Promise<void> {
  const found = await ask('GET /api/cells/{cell}/twin', { path: { cell } });
  if (watched.value === cell) twin.value = found;
}

async function readAddition(cell: string, addition_id: string): Promise<void> {
  const path = { cell, addition: addition_id };
  const found = await ask('GET /api/cells/{cell}/twin/additions/{addition}', { path });
  if (addition.value?.addition !== addition_id) return;
  addition.value = found;
  if (found.twin !== null && watched.value === cell) twin.value = found.twin;
}

effect(() => {
  const cell = watched.value;
  twin.value = null;
  return session.value && cell !== null ? every(ASK_TWIN_MS, () => readTwin(cell)) : undefined;
});

/** As text, so that it changes only with the addition, not with its progress. */
const pending = computed(() => {
  const asked = addition.value;
  return asked !== null && isUnderWay(asked) ? `${asked.cell}/${asked.addition}` : '';
});
effect(() => {
  const [cell = '', id = ''] = pending.value.split('/');
  return session.value && id ? every(ASK_JOB_MS, () => readAddition(cell, id)) : undefined;
});
