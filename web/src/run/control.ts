import { computed, effect, signal } from '@preact/signals';
import type { ControlAnswer } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { nameOf } from '../ui/names';
import { Flaw } from '../ui/notice';
import { Refusal } from '../ui/refusal';
import { cellLive } from './cell-live';
import { dropControl, hearFence, keepControl, leasedCell, ownFence } from './lease';

/** Who is in control of the chosen cell, over which connection, as the service said last. */
export const control = signal<ControlAnswer | null>(null);

/** Whether it is this very screen that is in control of the chosen cell, also while its connection is lost. */
export const mine = computed(() => leasedCell.value !== null && leasedCell.value === chosenCell.value);
/** Somebody's name, or null where nobody is in control. */
export const holder = computed(() => (control.value?.holder ? nameOf(control.value.holder) : null));

/** Takes control; resolves when the first stamp was answered. */
export async function takeControl(cell: string): Promise<void> {
  dropControl();
  const taken = await ask('POST /api/control', { body: { cell } });
  if (taken.fence === null) throw new Flaw('control-not-taken');
  await keepControl(cell, taken.fence);
  control.value = taken;
}

/** Gives control back; a service that says no has none of ours any more. */
export async function giveControlBack(): Promise<void> {
  const [cell, fence] = [leasedCell.value, ownFence()];
  if (cell === null || fence === null) return;
  dropControl();
  await ask('DELETE /api/control/{cell}', { path: { cell }, query: { fence } }).catch((error) => {
    if (!(error instanceof Refusal)) throw error;
  });
}

effect(() => {
  const said = cellLive.value?.control ?? null;
  control.value = said;
  if (said !== null && mine.peek()) hearFence(said.fence);
});
effect(() => {
  if (session.value === null) dropControl();
});
