import { effect, signal } from '@preact/signals';
import type { RunPublic, TimelinePublic } from '../api';
import { session } from '../session/session';
import { sought } from '../ui/absent';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { told } from '../ui/notice';
import { route } from '../ui/route';
import type { timeline } from '../words/en-timeline';
import { pageWords } from '../words/page-words';

export type TimelineWords = typeof timeline;

/** The texts of a timeline in the chosen language; they are loaded with its page. */
export const timelineWords = pageWords(
  import.meta.glob<TimelineWords>('../words/*-timeline.ts', { eager: true, import: 'timeline' }),
);

/** The runs that the address names by their names, and what their diagnoses tell together. */
export interface ReadTimeline {
  runs: Map<string, RunPublic>;
  answer: TimelinePublic;
}

/** The one that is looked at; null until it is known. */
export const shown = signal<ReadTimeline | null>(null);

async function read(names: string[]): Promise<ReadTimeline> {
  const runs = await Promise.all(names.map((run) => ask('GET /api/runs/{run}', { path: { run } })));
  const answer = await ask('GET /api/timeline', { query: { run: names } });
  return { runs: new Map(runs.map((run) => [run.run, run])), answer };
}

effect(() => {
  const [page, ...named] = route.value;
  shown.value = null;
  if (!session.value || page !== 'timeline' || named.length === 0) return undefined;
  return until(async () => {
    shown.value = await sought(read(named)).catch(told);
  });
});
