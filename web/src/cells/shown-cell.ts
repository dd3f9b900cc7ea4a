import { computed, effect, signal } from '@preact/signals';
import type { CellPublic, Flaw, Zone, ZonePlace } from '../api';
import { session } from '../session/session';
import { absent, sought } from '../ui/absent';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { route } from '../ui/route';
import { cells, cell as chosen, chosenCell, readCell, readCells } from './cells';
import { onlyMoved, type Shape } from './shapes';

const ASK_MS = 1000;

/** Name of the cell that is looked at: on the page of the cells any of them, where a run is set up the one that this console stands at. */
export const looked = computed(() => {
  const [page = '', name] = route.value;
  if (page === 'cells') return name ?? chosenCell.value;
  return page === '' ? chosenCell.value : '';
});
/** It, its zones where they are now; null until it is known. */
export const shownCell = signal<CellPublic | null>(null);
/** By how much the service's clock goes before this tablet's. */
let ahead_ms = 0;

async function readShown(name: string): Promise<void> {
  const reading = ask('GET /api/cells/{cell}', { path: { cell: name } });
  const found = await (route.value[1] === undefined ? reading : sought(reading));
  if (looked.value !== name) return;
  ahead_ms = Date.parse(found.read_at) - Date.now();
  shownCell.value = found;
  if (name === chosenCell.value && chosen.peek() === null) chosen.value = found.cell;
  const listed = cells.peek()?.find((each) => each.name === name);
  if (listed && sayOf(listed.flaws) !== sayOf(found.flaws)) await readCells();
}

const sayOf = (flaws: Flaw[]) => JSON.stringify(flaws);

/** A zone as somebody has drawn it; `original` is how it was when they began, null of a new one. */
export interface DrawnZone {
  name: string;
  original: Zone | null;
  shape: Shape;
}

/** Keeps a zone as it was drawn. One that has only moved is kept wherever it is: people are where they are. */
export async function saveZone({ name: zone, original, shape }: DrawnZone): Promise<void> {
  const cell = looked.value;
  const path = { cell, zone };
  if (original === null) {
    await ask('POST /api/cells/{cell}/zones', { path: { cell }, body: { name: zone, shape } });
  } else if (onlyMoved(original.shape, shape)) {
    const measured_at = new Date(Date.now() + ahead_ms).toISOString();
    await ask('PUT /api/cells/{cell}/zones/{zone}', { path, body: { pose: shape.pose ?? {}, measured_at } });
  } else {
    await ask('PUT /api/cells/{cell}/zones/{zone}/shape', { path, body: { shape } });
  }
  await readShown(cell);
}

/** What speaks against a zone as it is drawn; nothing of it counts yet. */
export async function checkZone({ name: zone, original, shape }: DrawnZone): Promise<Flaw[]> {
  const path = { cell: looked.value, zone };
  const body = { shape, new: original === null };
  return (await ask('POST /api/cells/{cell}/zones/{zone}/check', { path, body })).flaws;
}

/** Takes a zone out of the cell; it can be put back. */
export async function deleteZone(zone: string): Promise<void> {
  const cell = looked.value;
  await ask('DELETE /api/cells/{cell}/zones/{zone}', { path: { cell, zone } });
  await readShown(cell);
}

/** Puts a zone back, unless it has changed again since it was shown here. */
export async function putZoneBack({ zone, moves }: ZonePlace, to: 'before' | 'file'): Promise<void> {
  const cell = looked.value;
  await ask('POST /api/cells/{cell}/zones/{zone}/undo', { path: { cell, zone }, body: { to, moves } });
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
  if (name === chosenCell.value) await readCell(name);
}

effect(() => {
  const name = looked.value;
  shownCell.value = null;
  return session.value && name && !absent.value ? every(ASK_MS, () => readShown(name)) : undefined;
});
