import { signal } from '@preact/signals';
import type { CellNow } from '../api';
import { ask } from '../ui/client';
import { hearAll } from '../ui/socket';

/** What every robot of the service that a run has does now; told to anybody, also who is not signed in. Null until it is known. */
export const robots = signal<CellNow[] | null>(null);

/** Begins to follow all robots, for as long as the page is there. */
export function followRobots(): void {
  hearAll<{ at: string; robots: CellNow[] }>('/api/now/live', (message) => {
    if (JSON.stringify(message.robots) !== JSON.stringify(robots.value)) robots.value = message.robots;
  });
}

/** Stops the robot of a cell: anybody may, and neither the database nor a session is needed for it. */
export async function stopRobot(cell: string): Promise<void> {
  await ask('POST /api/now/{cell}/stop', { path: { cell } });
}
