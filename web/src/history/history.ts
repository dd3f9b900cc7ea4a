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
/** Who types is not asked about every letter. */
const TYPING_MS = 300;
/** Letters that the service searches for. */
const LONGEST = 200;
const MOST = 500;

/** The cell whose runs are shown: the one that this console stands at, where the address names no other. */
export const historyCell = computed(() => filters.value.get('cell') ?? chosenCell.value);
/** The tool whose runs are shown: by its name, or by its identifier where it was saved; empty is any. */
export const historyTool = computed(() => filters.value.get('saved') ?? filters.value.get('tool') ?? '');
const isSaved = computed(() => filters.value.get('saved') !== null);
/** What the runs have to contain; empty is anything. */
export const search = computed(() => filters.value.get('search') ?? '');
const length = signal(PAGE);
/** Words of this console, such as states and times, are searched for in as many runs as the service gives at once. */
const limit = computed(() => (search.value ? MOST : length.value));

/** The runs of the cell and tool, newest first; null until they are known. */
export const past = signal<RunPublic[] | null>(null);
/** What the service found of all runs, by what it knows: identifiers, people, days. */
const sought = signal<RunPublic[]>([]);
/** The runs that contain what is searched for, newest first. */
export const found = computed(() => {
  if (past.value === null) return null;
  const shown = past.value.filter((run) => matches(run, search.value));
  const known = new Set(shown.map(({ run }) => run));
  return [...shown, ...sought.value.filter(({ run }) => !known.has(run))].sort((a, b) =>
    a.run < b.run ? 1 : -1,
  );
});
export const mayHaveEarlier = computed(() => past.value?.length === limit.value && limit.value < MOST);
/** Whether there may be runs in which the console's own words were not searched for. */
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

interface Wanted {
  limit: number;
  search?: string;
}

/** Runs of a cell and tool; null where others are wanted by now. */
async function readRunsOf(cell: string, tool: string, wanted: Wanted): Promise<RunPublic[] | null> {
  const named = isSaved.value ? { saved_payload: tool } : { payload: tool };
  const query = { cell, ...wanted, ...(tool ? named : {}) };
  const read = await ask('GET /api/runs', { query });
  return cell === historyCell.value && tool === historyTool.value ? read : null;
}

async function readPast(cell: string, tool: string, limit: number): Promise<void> {
  past.value = (await readRunsOf(cell, tool, { limit })) ?? past.value;
}

async function seek(cell: string, tool: string, words: string): Promise<void> {
  const read = await readRunsOf(cell, tool, { limit: MOST, search: words });
  if (read !== null && search.value.startsWith(words)) sought.value = read;
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
effect(() => {
  const [cell, tool, words] = [historyCell.value, historyTool.value, search.value.slice(0, LONGEST)];
  sought.value = [];
  if (!looking.value || !cell || words.trim() === '') return undefined;
  let stop = () => {};
  const timer = window.setTimeout(() => {
    stop = every(ASK_MANY_MS, () => seek(cell, tool, words));
  }, TYPING_MS);
  return () => {
    window.clearTimeout(timer);
    stop();
  };
});
