import { computed, effect, signal } from '@preact/signals';
import type { ControlPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { nameOf } from '../ui/names';
import { Flaw } from '../ui/notice';
import { Refusal } from '../ui/refusal';
import { cellLive } from './cell-live';
import { device } from './control-device';
import { tellHandover } from './control-told';
import {
  askingFence,
  dropAsking,
  dropControl,
  hearFence,
  hearRequest,
  keepAsking,
  keepControl,
  leasedCell,
  ownFence,
  receiveControl,
} from './lease';

/** How long control may take to pass to another screen of the same person. */
const PASS_MS = 3000;

/** Who is in control of the chosen cell, over which connection, as the service said last. */
export const control = signal<ControlPublic | null>(null);

/** Whether it is this very screen that is in control of the chosen cell, also while its connection is lost. */
export const mine = computed(() => leasedCell.value !== null && leasedCell.value === chosenCell.value);
/** Somebody's name, or null where nobody is in control. */
export const holder = computed(() => (control.value?.holder ? nameOf(control.value.holder) : null));
/** Whether whoever is signed in here is in control, but on another screen. */
export const elsewhere = computed(() => !mine.value && holder.value === (session.value?.name ?? ''));
/** Whether this screen asks for control. */
export const asked = computed(() => askingFence.value !== null);

/** Takes control; resolves when the first stamp was answered. Control of one's own on another screen passes without a gap. */
export async function takeControl(cell: string): Promise<void> {
  if (elsewhere.peek() && cell === chosenCell.peek()) {
    await askForControl(cell);
    await received();
    return;
  }
  dropControl();
  const taken = await ask('POST /api/control', { body: { cell, device: device.value } });
  if (taken.fence === null) throw new Flaw('control-not-taken');
  await keepControl(cell, taken.fence);
  control.value = taken;
}

/** Asks whoever is in control to hand it over; resolves when it is asked for. */
export async function askForControl(cell: string): Promise<void> {
  const { request } = await ask('POST /api/control/{cell}/request', {
    path: { cell },
    body: { device: device.value },
  });
  if (request === null) throw new Flaw('control-not-taken');
  await keepAsking(cell, request.fence);
}

/** Hands control over to whoever asks, or keeps it. */
export async function answerRequest(cell: string, request: number, accept: boolean): Promise<void> {
  const fence = ownFence();
  if (fence === null) throw new Flaw('not-in-control');
  const body = { fence, request, accept };
  control.value = await ask('POST /api/control/{cell}/request/answer', { path: { cell }, body });
}

/** Asks no longer. */
export async function withdrawRequest(cell: string): Promise<void> {
  const fence = askingFence.value;
  if (fence === null) return;
  dropAsking();
  control.value = await ask('DELETE /api/control/{cell}/request', { path: { cell }, query: { fence } });
}

/** Gives control back; a service that says no has none of ours any more. */
export async function giveControlBack(): Promise<void> {
  const [cell, fence] = [leasedCell.value, ownFence()];
  if (cell === null || fence === null) return;
  await ask('DELETE /api/control/{cell}', { path: { cell }, query: { fence } }).catch((error) => {
    if (!(error instanceof Refusal)) throw error;
  });
  dropControl();
}

/** Resolves when this screen is in control. */
function received(): Promise<void> {
  return new Promise((resolve, reject) => {
    const late = window.setTimeout(() => {
      stop();
      dropAsking();
      reject(new Flaw('control-not-taken'));
    }, PASS_MS);
    const stop = leasedCell.subscribe((cell) => {
      if (cell === null) return;
      window.clearTimeout(late);
      queueMicrotask(() => stop());
      resolve();
    });
  });
}

effect(() => {
  control.value = cellLive.value?.control ?? null;
});
effect(() => {
  const said = control.value;
  if (said === null) return;
  tellHandover(said, mine.peek() ? ownFence() : null, askingFence.peek());
  if (said.fence !== null && said.fence === askingFence.peek()) receiveControl();
  if (askingFence.peek() !== null && said.last_request?.fence === askingFence.peek()) dropAsking();
  hearRequest(said.request?.fence ?? null);
  if (mine.peek()) hearFence(said.fence);
});
effect(() => {
  if (session.value !== null) return;
  dropControl();
  dropAsking();
});
