import { computed, effect, signal, untracked } from '@preact/signals';
import type { RunCommand, RunCreate, RunPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { cellLive } from './cell-live';
import { sent } from './lease';

/** What happens to the run that has the cell is told; the list beside it changes seldom. */
const ASK_MS = 30_000;
const RETRY_MS = 1000;
const FINAL = new Set<RunPublic['state']>(['Complete', 'Stopped']);

/** The newest runs of the chosen cell, newest first; null until they are known. */
export const runs = signal<RunPublic[] | null>(null);
/** The run that has the cell, else the oldest that is not over. */
export const activeRun = computed(
  () => cellLive.value?.run ?? runs.value?.findLast((run) => !isOver(run)) ?? null,
);
/** Which run that is and its state, as text, so that it changes only with them. */
const activeState = computed(() => `${activeRun.value?.run} ${activeRun.value?.state}`);

/** Whether a run has let go of its cell. */
export function isOver(run: RunPublic): boolean {
  return FINAL.has(run.state);
}

export async function readRuns(): Promise<void> {
  const cell = chosenCell.value;
  const found = await ask('GET /api/runs', { query: { cell, limit: 30 } });
  if (chosenCell.value === cell) runs.value = found;
}

/** Queues a run; nothing moves before its plan is released. */
export async function queueRun(order: RunCreate): Promise<RunPublic> {
  const queued = await ask('POST /api/runs', { body: order, header: newKey() });
  void readRuns();
  return queued;
}

/** Queues the motion that a diagnosis proposes, as a run like any other. */
export async function queueMotion(diagnosis: string): Promise<RunPublic> {
  const path = { diagnosis };
  const queued = await ask('POST /api/diagnoses/{diagnosis}/motion', { path, body: {}, header: newKey() });
  void readRuns();
  return queued;
}

function newKey(): { 'Idempotency-Key': string } {
  return { 'Idempotency-Key': crypto.getRandomValues(new Uint32Array(4)).join('-') }; // randomUUID wants TLS
}

/** Queues the rest of a run that ended before it was through; what it has finished counts. */
export async function continueRun(run: string): Promise<RunPublic> {
  const path = { run };
  const queued = await ask('POST /api/runs/{run}/continuation', { path, header: newKey() });
  void readRuns();
  return queued;
}

/** A command of whoever is in control. Stops need no control: see `stopRobot`. */
export async function commandRun(run: string, command: RunCommand): Promise<void> {
  await ask('POST /api/runs/{run}/commands', { path: { run }, body: { command, sent: sent() } });
  void readRuns();
}

effect(() => {
  const name = chosenCell.value;
  untracked(() => {
    runs.value = null;
  });
  return session.value && name ? every(ASK_MS, readRuns, RETRY_MS) : undefined;
});
effect(() => {
  if (activeState.value && runs.peek() !== null) void readRuns().catch(() => undefined);
});
effect(() => {
  const told = cellLive.value;
  const listed = runs.peek();
  if (told?.run === null && listed?.some((run) => !isOver(run))) void readRuns().catch(() => undefined);
});
