import { batch, computed, effect, signal } from '@preact/signals';
import type { PlanPublic } from '../api';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { sent } from './lease';
import { newest, run } from './run';
import { readRuns } from './runs';

const TICK_MS = 250;

/** The plan that waits for its release, as it is shown. */
export const plan = signal<PlanPublic | null>(null);
const until_ms = signal(0);
const now_ms = signal(performance.now());
/** Seconds for which the shown plan may still be released. */
export const offered_s = computed(() => Math.max(0, (until_ms.value - now_ms.value) / 1000));

/** Shows the plan anew, with a new offer to release exactly it. */
export async function showPlan(id: string): Promise<void> {
  const asked_ms = performance.now();
  const found = await ask('GET /api/runs/{run}/plan', { path: { run: id } });
  if (run.value?.run !== id) return;
  batch(() => {
    plan.value = found;
    until_ms.value = asked_ms + 1000 * found.expires_s;
    now_ms.value = performance.now();
  });
}

/** Lets exactly the shown plan begin. */
export async function releasePlan(shown: PlanPublic): Promise<void> {
  const body = { plan_sha256: shown.plan.sha256, offer: shown.offer, sent: sent() };
  const released = await ask('POST /api/runs/{run}/release', { path: { run: shown.run }, body });
  if (run.value?.run === shown.run) run.value = released;
  void readRuns();
}

const waiting = computed(() => (run.value?.state === 'Idle' ? run.value.run : null));
const shownSha = computed(() => newest('plan_shown')?.sha256 ?? null);

effect(() => {
  const id = waiting.value;
  const changed = shownSha.value;
  plan.value = null;
  return id !== null && changed !== null ? until(() => showPlan(id)) : undefined;
});
effect(() => {
  if (plan.value === null) return undefined;
  const timer = window.setInterval(() => {
    now_ms.value = performance.now();
  }, TICK_MS);
  return () => window.clearInterval(timer);
});
