import { computed, effect, signal } from '@preact/signals';
import type { RunPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { every, until } from '../ui/connection';
import { filters, route, setFilter } from '../ui/route';
import { matches } from './run-text';

const ASK_MS = 3000;
/** Many runs are a lot to send again and again. */
const ASK_MANY_MS = 30_000;
const PAGE = 50;
const MOST = 500;

/** The cell whose runs are shown: the one that this console stands at, where the address names no other. */
export const historyCell = computed(() => filters.value.get('cell') ?? chosenCell.value);
/** The tool whose runs are shown; empty is any. */
export const historyTool = computed(() => filters.value.get('tool') ?? '');
/** What the runs have to contain; empty is anything. */
export const search = computed(() => filters.value.get('search') ?? '');
const length = signal(PAGE);
/** What is searched for may be in any run: as many are read as the service gives at once. */
const limit = computed(() => (search.value ? MOST : length.value));

/** The runs of the cell and tool, newest first; null until they are known. */
export const past = signal<RunPublic[] | null>(null);
/** Those of them that contain what is searched for. */
export const found = computed(() => past.value?.filter((run) => matches(run, search.value)) ?? null);
export const mayHaveEarlier = computed(() => past.value?.length === limit.value && limit.value < MOST);
/** Whether there may be runs that were not searched. */
export const isCutOff = computed(() => past.value?.length === MOST);
/** The runs picked to be compared: at most two, in the order in which they were picked. */
export const pair = signal<string[]>([]);

export function pickCell(name: string): void {
  setFilter('tool', '');
  setFilter('cell', name === chosenCell.value ? '' : name);
  begin();
}

export function pickTool(name: string): void {
  setFilter('tool', name);
  begin();
}

function begin(): void {
  length.value = PAGE;
  pair.value = [];
}

export function showEarlier(): void {
  length.value = Math.min(MOST, length.value + PAGE);
}

/** Picks a run to be compared, or takes it back; a third one takes the place of the first. */
export function pick(run: string): void {
  const others = pair.value.filter((each) => each !== run);
  pair.value = others.length < pair.value.length ? others : [...others.slice(-1), run];
}

/** The tools that the cell knows, by name. */
export const historyTools = signal<[string, string][]>([]);

async function readTools(cell: string): Promise<void> {
  const read = await ask('GET /api/cells/{cell}', { path: { cell } });
  if (cell !== historyCell.value) return;
  historyTools.value = Object.entries(read.cell?.payloads ?? {}).map(([name, { title }]) => [name, title]);
}

async function readPast(cell: string, payload: string, most: number): Promise<void> {
  const query = { cell, limit: most, ...(payload ? { payload } : {}) };
  const read = await ask('GET /api/runs', { query });
  if (cell === historyCell.value && payload === historyTool.value) past.value = read;
}

const looking = computed(() => Boolean(session.value) && route.value[0] === 'history');

effect(() => {
  const cell = historyCell.value;
  historyTools.value = [];
  return looking.value && cell ? until(() => readTools(cell)) : undefined;
});
effect(() => {
  void [historyCell.value, historyTool.value];
  past.value = null;
});
effect(() => {
  const [cell, payload, most] = [historyCell.value, historyTool.value, limit.value];
  const pause_ms = most === PAGE ? ASK_MS : ASK_MANY_MS;
  return looking.value && cell ? every(pause_ms, () => readPast(cell, payload, most)) : undefined;
});
