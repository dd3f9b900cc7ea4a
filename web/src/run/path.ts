import { computed, effect, signal } from '@preact/signals';
import type { PathPart } from '../api';
import { plan } from './plan';

const TICK_MS = 100;
/** However long the robot takes, the whole path is played in this time. */
const PLAYED_S = 25;

interface Part extends PathPart {
  /** When it begins, and how long it takes, robot time without the holds. */
  begin_s: number;
  lasts_s: number;
}

/** The motions of the plan that is shown, one after the other. */
const parts = computed<Part[]>(() => {
  let begin_s = 0;
  return (plan.value?.plan.paths ?? []).map((path) => {
    const part = { ...path, begin_s, lasts_s: path.period_s * (path.q_rad.length - 1) };
    begin_s += part.lasts_s;
    return part;
  });
});
/** How long the robot moves along the whole path. */
export const path_s = computed(() => parts.value.reduce((sum, { lasts_s }) => sum + lasts_s, 0));
/** Where on the path the planned robot is drawn; null while none is. */
export const moment_s = signal<number | null>(null);
export const playing = signal(false);

/** The motion that is looked at. */
export const partNow = computed<Part | null>(() => {
  const at = moment_s.value;
  return at === null
    ? null
    : (parts.value.findLast(({ begin_s }) => begin_s <= at) ?? parts.value[0] ?? null);
});
/** Joint positions of the planned robot. */
export const planned_rad = computed<number[] | null>(() => {
  const [part, at] = [partNow.value, moment_s.value];
  if (part === null || at === null) return null;
  const row = Math.min(Math.max((at - part.begin_s) / part.period_s, 0), part.q_rad.length - 1);
  const [before = [], after = []] = [part.q_rad[Math.floor(row)], part.q_rad[Math.ceil(row)]];
  return before.map((angle, joint) => angle + (row % 1) * ((after[joint] ?? angle) - angle));
});

/** Plays the path from where it is looked at; from its beginning where that is its end. */
export function play(): void {
  if ((moment_s.value ?? 0) >= path_s.value) moment_s.value = 0;
  playing.value = true;
}

effect(() => {
  if (plan.value?.plan.sha256 === undefined) {
    playing.value = false;
    moment_s.value = null;
  }
});
effect(() => {
  if (!playing.value) return undefined;
  const timer = window.setInterval(() => {
    const step_s = (TICK_MS / 1000) * Math.max(1, path_s.value / PLAYED_S);
    const next_s = (moment_s.value ?? 0) + step_s;
    moment_s.value = Math.min(next_s, path_s.value);
    if (next_s >= path_s.value) playing.value = false;
  }, TICK_MS);
  return () => window.clearInterval(timer);
});
