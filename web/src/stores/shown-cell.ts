import { computed, effect, signal } from '@preact/signals';
import type { CellShown } from '../api';
import { ask } from '../client';
import { route } from '../route';
import { absent, sought } from './absent';
import { chosenCell, readCells } from './cells';
import { every } from './connection';
import { session } from './session';

const ASK_MS = 1000;

/** Name of the cell that is looked at, which need not be the one that this console stands at. */
export const looked = computed(() =>
  route.value[0] === 'cells' ? (route.value[1] ?? chosenCell.value) : '',
);
/** It, its zones where they are now; null until it is known. */
export const shownCell = signal<CellShown | null>(null);
/** By how much the service's clock goes before this tablet's. */
let ahead_ms = 0;

async function readShown(name: string): Promise<void> {
  const reading = ask('GET /api/cells/{cell}', { path: { cell: name } });
  const found = await (route.value[1] === undefined ? reading : sought(reading));
  if (looked.value !== name) return;
  ahead_ms = Date.parse(found.read_at) - Date.now();
  shownCell.value = found;
}

/** Says where the centre of a zone is now, in the world frame; it keeps its axes. */
export async function moveZone(zone: string, xyz_m: [number, number, number]): Promise<void> {
  const cell = looked.value;
  const shape = shownCell.value?.cell.zones?.find((each) => each.name === zone)?.shape;
  const pose = { ...shape?.pose, xyz_m };
  const measured_at = new Date(Date.now() + ahead_ms).toISOString();
  await ask('PUT /api/cells/{cell}/zones/{zone}', { path: { cell, zone }, body: { pose, measured_at } });
  await readShown(cell);
}

/** Checks a zip of a cell and keeps nothing; gives the cell's name. */
export async function checkCell(zip: File): Promise<string> {
  return (await ask('POST /api/cells/validate', { zip })).name;
}

/** Takes a checked cell in, in place of the one of that name where there is one. */
export async function takeCellIn(zip: File, name: string, replaces: boolean): Promise<void> {
  if (replaces) await ask('PUT /api/cells/{cell}', { path: { cell: name }, zip });
  else await ask('POST /api/cells', { zip });
  await readCells();
}

effect(() => {
  const name = looked.value;
  shownCell.value = null;
  return session.value && name && !absent.value ? every(ASK_MS, () => readShown(name)) : undefined;
});
