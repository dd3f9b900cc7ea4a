import type { ComparisonPublic, ResultPublic, RunPublic } from '../api';
import { ask } from '../ui/client';

/** Two runs and what differs between them: the later one minus the earlier one. */
export interface Compared {
  runs: [RunPublic, RunPublic];
  results: [ResultPublic, ResultPublic];
  answer: ComparisonPublic;
}

/** Compares two runs, whichever was first; the names of runs are in their order in time. */
export async function compare(one: string, other: string): Promise<Compared> {
  const [first, second] = one < other ? [one, other] : [other, one];
  const read = (run: string) => ask('GET /api/runs/{run}', { path: { run } });
  const readResult = (run: string) => ask('GET /api/runs/{run}/result', { path: { run } });
  const answer = await ask('GET /api/runs/{run}/comparison/{other}', { path: { run: first, other: second } });
  return {
    runs: [await read(first), await read(second)],
    results: [await readResult(first), await readResult(second)],
    answer,
  };
}

/** The run before this one with the same tool in the same cell, or null. */
export async function runBefore({ run, cell, payload }: ResultPublic): Promise<string | null> {
  if (cell === null || payload === null) return null;
  const query = { cell, payload, state: 'Complete' as const, before: run, limit: 1 };
  const found = await ask('GET /api/runs', { query });
  return found[0]?.run ?? null;
}
