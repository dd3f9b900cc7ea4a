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
/** The tool whose runs are shown: by its name, or by its identifier where it was saved; empty is any. */
export const historyTool = computed(() => filters.value.get('saved') ?? filters.value.get('tool') ?? '');
const isSaved = computed(() => filters.value.get('saved') !== null);
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
/** The runs picked to be compared, in the order in which they were picked. */
export const picked = signal<string[]>([]);
/** As many as the service takes for one series. */
const MOST_PICKED = 50;

export function pickCell(name: string): void {
  setFilter('tool', '');
  setFilter('saved', '');
  setFilter('cell', name === chosenCell.value ? '' : name);
  begin();
}

export function pickTool(name: string): void {
  const saved = historyTools.value.find((each) => each.value === name)?.saved ?? false;
  setFilter('tool', saved ? '' : name);
  setFilter('saved', saved ? name : '');
  begin();
}

function begin(): void {
  length.value = PAGE;
  picked.value = [];
}

export function showEarlier(): void {
  length.value = Math.min(MOST, length.value + PAGE);
}

/** Picks a run to be compared, or takes it back; one too many takes the place of the first. */
export function pick(run: string): void {
  const others = picked.value.filter((each) => each !== run);
  picked.value = others.length < picked.value.length ? others : [...others.slice(1 - MOST_PICKED), run];
}

interface HistoryTool {
  /** As `historyTool` has it. */
  value: string;
  title: string;
  saved: boolean;
}

/** The tools that the cell knows. */
export const historyTools = signal<HistoryTool[]>([]);

async function readTools(cell: string): Promise<void> {
  const read = await ask('GET /api/cells/{cell}/payloads', { path: { cell } });
  if (cell !== historyCell.value) return;
  historyTools.value = read.map(({ id, name, title }) => ({ value: id ?? name, title, saved: id !== null }));
}

async function readPast(cell: string, tool: string, most: number): Promise<void> {
  const named = isSaved.value ? { saved_payload: tool } : { payload: tool };
  const query = { cell, limit: most, ...(tool ? named : {}) };
  const read = await ask('GET /api/runs', { query });
  if (cell === historyCell.value && tool === historyTool.value) past.value = read;
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
  const [cell, tool, most] = [historyCell.value, historyTool.value, limit.value];
  const pause_ms = most === PAGE ? ASK_MS : ASK_MANY_MS;
  return looking.value && cell ? every(pause_ms, () => readPast(cell, tool, most)) : undefined;
});
