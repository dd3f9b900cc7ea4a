import { effect, signal } from '@preact/signals';
import type { DiagnosisPublic, RunPublic, TimelinePublic } from '../api';
import { session } from '../session/session';
import { sought } from '../ui/absent';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { told } from '../ui/notice';
import { go, route } from '../ui/route';
import type { timeline } from '../words/en-timeline';
import { pageWords } from '../words/page-words';

export type TimelineWords = typeof timeline;

/** The texts of a timeline in the chosen language; they are loaded with its page. */
export const timelineWords = pageWords(
  import.meta.glob<TimelineWords>('../words/*-timeline.ts', { eager: true, import: 'timeline' }),
);

/** Of pieces of the address that name the diagnosis of an uploaded recording; the others name runs. */
const UPLOAD = 'upload-';
/** So many of the newest diagnoses are looked through for uploaded recordings. */
const LOOKED_AT = 200;

/** The runs that the address names by their names, what all that it names tells together, and what could be added. */
export interface ReadTimeline {
  runs: Map<string, RunPublic>;
  answer: TimelinePublic;
  /** Diagnosed uploads that the address does not name, the newest first. */
  more: DiagnosisPublic[];
}

/** The one that is looked at; null until it is known. */
export const shown = signal<ReadTimeline | null>(null);

async function read(named: string[]): Promise<ReadTimeline> {
  const runNames = named.filter((name) => !name.startsWith(UPLOAD));
  const uploads = named.filter((name) => name.startsWith(UPLOAD)).map((name) => name.slice(UPLOAD.length));
  const runs = await Promise.all(runNames.map((run) => ask('GET /api/runs/{run}', { path: { run } })));
  const answer = await ask('GET /api/timeline', { query: { run: runNames, diagnosis: uploads } });
  const all = await ask('GET /api/diagnoses', { query: { limit: LOOKED_AT } });
  const more = all.filter(
    ({ run, state, diagnosis }) => run === null && state === 'done' && !uploads.includes(diagnosis),
  );
  return { runs: new Map(runs.map((run) => [run.run, run])), answer, more };
}

/** Takes one more upload into what the address names. */
export function add({ diagnosis }: DiagnosisPublic): void {
  go(...route.value, UPLOAD + diagnosis);
}

effect(() => {
  const [page, ...named] = route.value;
  shown.value = null;
  if (!session.value || page !== 'timeline') return undefined;
  return until(async () => {
    shown.value = await sought(read(named)).catch(told);
  });
});
