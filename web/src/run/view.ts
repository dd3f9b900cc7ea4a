import { computed, effect, signal } from '@preact/signals';
import type { Box, ViewWish } from '../api';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { route } from '../ui/route';
import { box } from './order';
import { planned_rad } from './path';
import { activeRun } from './runs';

export type Look = NonNullable<ViewWish['look']>;

/** What this page calls its picture of a cell: the camera in it is its own, also after a reload. */
export const viewName = nameView();
/** Name of the cell that is drawn on this page; empty while none is. */
export const drawnCell = signal('');

/** The box as it is typed; null where the picture shows that of a run. */
const typedBox = computed<Box | null>(() =>
  route.value.length === 0 && activeRun.value === null ? box.value : null,
);
/** The zone that is being changed; null while none is. */
export const drawnZone = signal<NonNullable<ViewWish['zone']> | null>(null);
const wish = computed<ViewWish>(() => ({
  payload_box: typedBox.value,
  q_rad: planned_rad.value,
  zone: drawnZone.value,
}));
let sending = false;
let shown = '';

/** Turns the camera of this page's picture of a cell. */
export async function turnCamera(cell: string, look: Look): Promise<void> {
  await ask('PUT /api/cells/{cell}/views/{view}', {
    path: { cell, view: viewName },
    body: { ...wish.value, look },
  });
}

/** Has drawn what this page wants to see; while one wish is on its way, only the newest of those that follow goes out. */
async function draw(): Promise<void> {
  if (sending) return;
  sending = true;
  try {
    while (drawnCell.value !== '' && shown !== wanted()) {
      shown = wanted();
      const path = { cell: drawnCell.value, view: viewName };
      await ask('PUT /api/cells/{cell}/views/{view}', { path, body: wish.value });
    }
  } catch {
    shown = ''; // that the service cannot be reached stands on the page already; the next wish is sent whole
  }
  sending = false;
}

const wanted = () => drawnCell.value + JSON.stringify(wish.value);

function nameView(): string {
  const made = [...crypto.getRandomValues(new Uint8Array(12))].map((byte) => byte.toString(16)).join('');
  const found = sessionStorage.getItem('heft.view') ?? made;
  sessionStorage.setItem('heft.view', found);
  return found;
}

effect(() => {
  if (session.value && drawnCell.value && wish.value) void draw();
});
