import { computed, effect, signal } from '@preact/signals';
import type { EventMessage, ResultPublic, RunPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { absent, sought } from '../ui/absent';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { runInRoute } from '../ui/route';
import { cellLive } from './cell-live';
import { events, follow } from './live';
import { activeRun, isOver } from './runs';

/** What happens to it is told; this is for what nobody told. */
const ASK_MS = 30_000;
const RETRY_MS = 1000;

/** The run that the address names, as it stands now; null until it is known. */
export const run = signal<RunPublic | null>(null);
/** Its result, once it is Complete. */
export const result = signal<ResultPublic | null>(null);

/** The run that has the cell, as fresh as it is known; else the one that is looked at. */
export const current = computed(() => {
  const active = activeRun.value;
  return active === null || active.run === run.value?.run ? run.value : active;
});

/** States that come with more than an event says: a result, what may be continued. */
const RESTS = new Set<RunPublic['state']>(['Complete', 'Stopped', 'Aborted', 'Held', 'Idle']);

type LiveEvent = EventMessage['event'];

/** The newest event of a kind, or null. */
export function newest<K extends LiveEvent['kind']>(kind: K): Extract<LiveEvent, { kind: K }> | null {
  const found = events.value.findLast((message) => message.event.kind === kind);
  return (found?.event as Extract<LiveEvent, { kind: K }> | undefined) ?? null;
}

async function readRun(id: string): Promise<void> {
  const found = await sought(ask('GET /api/runs/{run}', { path: { run: id } }));
  if (runInRoute.value !== id) return;
  run.value = found;
  if (!isOver(found)) chosenCell.value = found.cell;
  if (found.state === 'Complete' && result.value?.run !== id) await readResult(id);
}

async function readResult(id: string): Promise<void> {
  const found = await ask('GET /api/runs/{run}/result', { path: { run: id } });
  if (runInRoute.value === id) result.value = found;
}

/** Takes the shown result for good. */
export async function acceptResult(id: string): Promise<void> {
  run.value = await ask('POST /api/runs/{run}/acceptance', { path: { run: id } });
}

function heard(id: string, message: EventMessage): void {
  const { event } = message;
  if (event.kind !== 'state_changed' || run.value?.run !== id || message.sequence <= run.value.sequence)
    return;
  const { state, job_state, outcome, commands, reason, reason_kind } = event;
  run.value = {
    ...run.value,
    sequence: message.sequence,
    state,
    job_state,
    outcome: outcome ?? null,
    commands,
    reason: reason ?? null,
    reason_kind: reason_kind ?? null,
  };
  if (RESTS.has(state)) void readRun(id).catch(() => undefined);
}

effect(() => {
  const id = runInRoute.value;
  run.value = null;
  result.value = null;
  if (!session.value || id === null || absent.value) return undefined;
  const ends = [every(ASK_MS, () => readRun(id), RETRY_MS), follow(id, (message) => heard(id, message))];
  return () => {
    for (const end of ends) end();
  };
});
effect(() => {
  const told = cellLive.value?.run ?? null;
  if (told !== null && told.run === runInRoute.value) run.value = told;
});
