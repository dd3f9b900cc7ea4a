import { computed, signal } from '@preact/signals';
import type { TrialsPublic } from '../api';
import { ask } from '../ui/client';
import { jobsOf } from '../ui/jobs';
import type { Language } from '../words/languages';

const SEEDS = 2 ** 31 - 1000;

/** Blind trials, and those that are looked at. */
export const { listed: trialsListed, shown: trials } = jobsOf<TrialsPublic>(
  'trials',
  () => ask('GET /api/trials', { query: { limit: 30 } }),
  (id) => ask('GET /api/trials/{trials}', { path: { trials: id } }),
);

/** The score sheet of trials that are done, Markdown. */
export async function readSheet(id: string, language: Language): Promise<string> {
  const path = { trials: id };
  return (await ask('GET /api/trials/{trials}', { path, query: { language } })).sheet ?? '';
}

/** Begins trials whose faults nobody has chosen: their seed is drawn here. */
export async function beginTrials(count: number): Promise<TrialsPublic> {
  const [drawn = 0] = crypto.getRandomValues(new Uint32Array(1));
  return ask('POST /api/trials', { body: { count, seed: drawn % SEEDS } });
}

export async function cancelTrials(id: string): Promise<void> {
  trials.value = await ask('DELETE /api/trials/{trials}', { path: { trials: id } });
}

/** Whose seals were opened on this screen. */
const openedOf = signal('');
/** Whether what was planted may be seen. */
export const opened = computed(() => trials.value !== null && openedOf.value === trials.value.trials);

export function openSeals(): void {
  openedOf.value = trials.value?.trials ?? '';
}
