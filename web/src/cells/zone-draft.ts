import { computed, signal } from '@preact/signals';
import type { Zone } from '../api';
import { drawnZone } from '../run/view';
import { alike, isDrawable, type Shape, type ShapeKind } from './shapes';
import { looked, shownCell } from './shown-cell';

/** A zone that somebody changes or draws: nothing of it counts before it is saved. */
export interface Draft {
  name: string;
  /** As it was when somebody took it up; null of a new one. */
  original: Zone | null;
  shape: Shape;
  /** What it was before each step, for the way back. */
  past: Shape[];
}

const NEW_NAME = 'zone';

/** What is being changed; null while nothing is. */
export const draft = signal<Draft | null>(null);
/** What kind of zone the next stroke in the picture draws; null where it draws none. */
export const drawing = signal<ShapeKind | null>(null);

/** Whether the draft differs from what is stored. */
export const changed = computed(() => {
  const now = draft.value;
  return now !== null && (now.original === null || !alike(now.original.shape, now.shape));
});

/** Takes up a zone that there is; what was taken up before and not saved is dropped. */
export function takeUp(zone: Zone): void {
  drawing.value = null;
  if (!isDrawable(zone.shape)) return;
  if (draft.value?.original?.name === zone.name) return;
  draft.value = { name: zone.name, original: zone, shape: zone.shape, past: [] };
}

/** A new zone of this shape, under a name that is free. */
export function begin(shape: Shape): void {
  drawing.value = null;
  draft.value = { name: freeName(), original: null, shape, past: [] };
}

export function rename(name: string): void {
  if (draft.value) draft.value = { ...draft.value, name };
}

/** One step: the way back leads before it. */
export function step(shape: Shape): void {
  const now = draft.value;
  if (now && !alike(now.shape, shape)) draft.value = { ...now, shape, past: [...now.past, now.shape] };
}

/** On the way of a step whose beginning is known: nothing is remembered. */
export function drag(shape: Shape): void {
  if (draft.value) draft.value = { ...draft.value, shape };
}

/** A drag is over, which began at a shape: that is the step. */
export function endDrag(from: Shape): void {
  const now = draft.value;
  if (now && !alike(now.shape, from)) draft.value = { ...now, past: [...now.past, from] };
}

/** Takes the latest step back. */
export function stepBack(): void {
  const now = draft.value;
  const before = now?.past.at(-1);
  if (now && before) draft.value = { ...now, shape: before, past: now.past.slice(0, -1) };
}

export function drop(): void {
  draft.value = null;
  drawing.value = null;
}

function freeName(): string {
  const cell = shownCell.value?.cell;
  const taken = new Set([...(cell?.zones ?? []), ...(cell?.obstacles ?? [])].map(({ name }) => name));
  for (let k = 1; ; k += 1) if (!taken.has(`${NEW_NAME}-${k}`)) return `${NEW_NAME}-${k}`;
}

looked.subscribe(drop);
/** The view in three dimensions shows it beside what is stored. */
draft.subscribe((now) => {
  drawnZone.value = now?.shape ?? null;
});
