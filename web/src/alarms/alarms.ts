import { computed, effect, signal, untracked } from '@preact/signals';
import type { AlarmPublic } from '../api';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { hearAll } from '../ui/socket';

const PAGE = 50;

/** Alarms that are open, newest first, as the service said last; null until they are known. */
export const openAlarms = signal<AlarmPublic[] | null>(null);
/** Those that nobody has acknowledged. */
export const unseen = computed(() =>
  (openAlarms.value ?? []).filter((alarm) => alarm.acknowledged_by === null),
);
/** Those that are over, newest first; null until they were asked for. */
export const pastAlarms = signal<AlarmPublic[] | null>(null);
/** Whether there may be more of them. */
export const mayHaveEarlier = signal(false);

/** Somebody has seen it. */
export async function acknowledge(alarm: string): Promise<void> {
  const seen = await ask('POST /api/alarms/{alarm}/acknowledgement', { path: { alarm } });
  openAlarms.value = (openAlarms.peek() ?? []).map((each) => (each.id === seen.id ? seen : each));
}

/** Reads the newest of those that are over. */
export async function readPast(): Promise<void> {
  const found = await ask('GET /api/alarms', { query: { limit: PAGE } });
  mayHaveEarlier.value = found.length === PAGE;
  pastAlarms.value = withoutOpen(found);
}

/** Reads those before. */
export async function readEarlier(): Promise<void> {
  const before = pastAlarms.peek()?.at(-1)?.id;
  const found = await ask('GET /api/alarms', { query: { limit: PAGE, ...(before && { before }) } });
  mayHaveEarlier.value = found.length === PAGE;
  pastAlarms.value = [...(pastAlarms.peek() ?? []), ...withoutOpen(found)];
}

function withoutOpen(alarms: AlarmPublic[]): AlarmPublic[] {
  const open = new Set((openAlarms.peek() ?? []).map(({ id }) => id));
  return alarms.filter(({ id }) => !open.has(id));
}

effect(() => {
  openAlarms.value = null;
  pastAlarms.value = null;
  if (!session.value) return undefined;
  return untracked(() =>
    hearAll<{ at: string; alarms: AlarmPublic[] | null }>('/api/alarms/live', ({ alarms }) => {
      if (alarms !== null) openAlarms.value = alarms;
    }),
  );
});
