import { effect, signal } from '@preact/signals';
import type { Box } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { until } from '../ui/connection';

/** What is bolted between the sensor and whatever the robot carries, as boxes in the sensor frame. */
export const bolted = signal<Box[]>([]);

async function readBolted(cell: string): Promise<void> {
  const found = await ask('GET /api/cells/{cell}/tools', { path: { cell } });
  if (chosenCell.value === cell) bolted.value = found.flatMap(({ boxes }) => boxes);
}

effect(() => {
  const cell = chosenCell.value;
  bolted.value = [];
  return session.value && cell ? until(() => readBolted(cell)) : undefined;
});
