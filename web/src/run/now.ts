import { signal } from '@preact/signals';
import type { CellNow } from '../api';
import { ask } from '../ui/client';
import { every } from '../ui/connection';

/** Often enough that a lost connection is told within some 1.5 s. */
const PULSE_MS = 500;
/** The same after a failure, which may be the only one. */
const RETRY_MS = 200;
const PATIENCE_MS = 2000;

/** What every robot of the service that a run has does now; told to anybody, also who is not signed in. Null until it is known. */
export const robots = signal<CellNow[] | null>(null);

async function readNow(): Promise<void> {
  const found = await ask('GET /api/now', { patience_ms: PATIENCE_MS });
  if (JSON.stringify(found) !== JSON.stringify(robots.value)) robots.value = found;
}

/** Begins to follow all robots, for as long as the page is there. */
export function followRobots(): void {
  every(PULSE_MS, readNow, RETRY_MS);
  window.addEventListener('online', () => void readNow().catch(() => undefined));
}

/** Stops the robot of a cell: anybody may, and neither the database nor a session is needed for it. */
export async function stopRobot(cell: string): Promise<void> {
  await ask('POST /api/now/{cell}/stop', { path: { cell } });
  await readNow();
}
