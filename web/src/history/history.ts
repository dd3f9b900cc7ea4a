import { computed, effect, signal } from '@preact/signals';
import type { RunAnswer } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { every, until } from '../ui/connection';
import { route } from '../ui/route';

const ASK_MS = 3000;
const PAGE = 50;
const MOST = 500;

/** The cell whose runs are shown: the one that this console stands at, where no other was picked. */
const pickedCell = signal<string | null>(null);
export const historyCell = computed(() => pickedCell.value ?? chosenCell.value);
/** The tool whose runs are shown; empty is any. */
export const historyTool = signal('');
const length = signal(PAGE);

/** The runs that fit, newest first; null until they are known. */
export const past = signal<RunAnswer[] | null>(null);
export const mayHaveEarlier = computed(() => past.value?.length === length.value && length.value < MOST);
/** The runs picked to be compared: at most two, in the order in which they were picked. */
export const pair = signal<string[]>([]);

export function pickCell(name: string): void {
  pickedCell.value = name;
  historyTool.value = '';
  begin();
}

export function pickTool(name: string): void {
  historyTool.value = name;
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
  const found = await ask('GET /api/cells/{cell}', { path: { cell } });
  if (cell !== historyCell.value) return;
  historyTools.value = Object.entries(found.cell?.payloads ?? {}).map(([name, { title }]) => [name, title]);
}

async function readPast(cell: string, payload: string, limit: number): Promise<void> {
  const query = { cell, limit, ...(payload ? { payload } : {}) };
  const found = await ask('GET /api/runs', { query });
  if (cell === historyCell.value && payload === historyTool.value) past.value = found;
}

const looking = computed(() => Boolean(session.value) && route.value[0] === 'history');

effect(() => {
  const cell = historyCell.value;
  historyTools.value = [];
  return looking.value && cell ? until(() => readTools(cell)) : undefined;
});
effect(() => {
  const [cell, payload, limit] = [historyCell.value, historyTool.value, length.value];
  if (limit === PAGE) past.value = null;
  return looking.value && cell ? every(ASK_MS, () => readPast(cell, payload, limit)) : undefined;
});
