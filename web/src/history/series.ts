import { computed, effect, signal } from '@preact/signals';
import type { RunPublic, SeriesPublic } from '../api';
import { session } from '../session/session';
import { sought } from '../ui/absent';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { told } from '../ui/notice';
import { filters, route, setFilter } from '../ui/route';

/** A series that was asked for: its runs in the order of time, and what they say together. */
export interface ReadSeries {
  runs: RunPublic[];
  conditions: string[] | null;
  answer: SeriesPublic;
}

/** What runs can differ in, beside the payload. */
export const CONDITIONS = {
  day: ({ ended_at, requested_at }: RunPublic) => new Date(ended_at ?? requested_at).toLocaleDateString('sv'),
  cell: ({ cell }: RunPublic) => cell,
  person: ({ released_by, requested_by }: RunPublic) => released_by ?? requested_by,
};
export type Condition = keyof typeof CONDITIONS;

/** Shares that a reference can be known to, percent. */
export const PRIORS = ['1', '2', '5', '10'];

/** By what the runs are told apart; null where all count as made under one condition. */
export const condition = computed<Condition | null>(() => {
  const named = filters.value.get('conditions') ?? '';
  return named in CONDITIONS ? (named as Condition) : null;
});
export const prior = computed(() => filters.value.get('prior') ?? '');

/** The series that the address names; null until it is known. */
export const shown = signal<ReadSeries | null>(null);

async function read(names: string[], by: Condition | null, percent: string): Promise<ReadSeries> {
  const runs = await Promise.all(names.map((run) => ask('GET /api/runs/{run}', { path: { run } })));
  const conditions = by === null ? null : runs.map(CONDITIONS[by]);
  const prior_percent = percent ? Number(percent) : null;
  const query = { run: names, condition: conditions, prior_percent };
  return { runs, conditions, answer: await ask('GET /api/series', { query, patience_ms: PATIENCE_MS }) };
}

/** Fifty runs are pooled; that takes longer than other answers. */
const PATIENCE_MS = 60_000;

effect(() => {
  const [page, ...named] = route.value;
  const [by, percent] = [condition.value, prior.value];
  shown.value = null;
  if (!session.value || page !== 'series' || named.length === 0) return undefined;
  // the names of runs are in their order in time
  return until(async () => {
    const found = await sought(read([...named].sort(), by, percent)).catch((error) => {
      // without a reference nothing is known before: the refusal says so, and the series is shown without
      if (percent) setFilter('prior', '');
      told(error);
      return null;
    });
    if (percent === prior.peek() && by === condition.peek()) shown.value = found;
  });
});
