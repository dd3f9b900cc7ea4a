import { computed, effect, signal } from '@preact/signals';
import type { CellPublic, Flaw, Pose, ZonePlace } from '../api';
import { session } from '../session/session';
import { absent, sought } from '../ui/absent';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { route } from '../ui/route';
import { cells, cell as chosen, chosenCell, readCell, readCells } from './cells';

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

/** Says where the centre of a zone is now, in the world frame; it keeps its axes. */
export async function moveZone(zone: string, xyz_m: [number, number, number]): Promise<void> {
  const cell = looked.value;
  const measured_at = new Date(Date.now() + ahead_ms).toISOString();
  const body = { pose: poseAt(zone, xyz_m), measured_at };
  await ask('PUT /api/cells/{cell}/zones/{zone}', { path: { cell, zone }, body });
  await readShown(cell);
}

/** What a zone would contradict there; it does not move. */
export async function checkZone(zone: string, xyz_m: [number, number, number]): Promise<Flaw[]> {
  const path = { cell: looked.value, zone };
  const body = { pose: poseAt(zone, xyz_m) };
  return (await ask('POST /api/cells/{cell}/zones/{zone}/check', { path, body })).flaws;
}

/** Puts a zone back, unless it has moved on since it was shown here. */
export async function putZoneBack({ zone, moves }: ZonePlace, to: 'before' | 'file'): Promise<void> {
  const cell = looked.value;
  await ask('POST /api/cells/{cell}/zones/{zone}/undo', { path: { cell, zone }, body: { to, moves } });
  await readShown(cell);
}

function poseAt(zone: string, xyz_m: [number, number, number]): Pose {
  const shape = shownCell.value?.cell?.zones?.find((each) => each.name === zone)?.shape;
  return { ...shape?.pose, xyz_m };
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
