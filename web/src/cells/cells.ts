import { effect, signal } from '@preact/signals';
import type { Cell, CellSummary } from '../api';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { kept } from '../ui/kept';

export type { Cell };

/** All cells; null until they are known. */
export const cells = signal<CellSummary[] | null>(null);
/** Name of the cell that this console stands at; empty where none was chosen. */
export const chosenCell = kept('cell', '', (_text): _text is string => true);
/** The chosen cell, its zones where they were when it was read; null also where its file cannot be read. */
export const cell = signal<Cell | null>(null);

export async function readCells(): Promise<void> {
  cells.value = await ask('GET /api/cells');
  const names = cells.value.map((each) => each.name);
  const usable = cells.value.find((each) => each.flaw === null)?.name;
  if (!names.includes(chosenCell.value)) chosenCell.value = usable ?? names[0] ?? '';
}

export async function readCell(name: string): Promise<void> {
  const found = await ask('GET /api/cells/{cell}', { path: { cell: name } });
  if (chosenCell.value === name) cell.value = found.cell;
}

effect(() => (session.value ? until(readCells) : undefined));
effect(() => {
  const name = chosenCell.value;
  cell.value = null;
  return session.value && name ? until(() => readCell(name)) : undefined;
});
