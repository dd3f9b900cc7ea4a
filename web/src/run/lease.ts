import { computed, signal } from '@preact/signals';
import type { FencingToken } from '../api';
import { socketAddress } from '../ui/client';
import { Flaw } from '../ui/notice';
import type { FromLease, ToLease } from './lease-worker';

const ALIVE_MS = 250;
/** As long as the service waits for the first answered stamp. */
const SETTLE_MS = 5000;
/** How long the service has to go on saying that this screen is not in control, or does not ask, until that is believed: a page that
 * stood still hears at once all that was said meanwhile. */
const DENIED_MS = 2000;

interface Lease {
  cell: string;
  fence: number;
  stamp_s: number;
  commands: number;
  /** When the service began to say so; null where it does not. */
  deniedSince_ms: number | null;
  end: () => void;
}

const lease = signal<Lease | null>(null);
/** With which this screen asks for control: it answers stamps already, and becomes the lease when control has passed. */
const asking = signal<Lease | null>(null);
/** Whether stamps are answered now; false while the worker opens a lost socket again. */
export const answering = signal(false);
/** The cell that this screen is in control of, also over a lost connection; null where it is of none. */
export const leasedCell = computed(() => lease.value?.cell ?? null);

/** The fence with which this screen asks for control of a cell, or null. */
export const askingFence = computed(() => asking.value?.fence ?? null);

/** Keeps control of a cell; resolves when the first stamp was answered. */
export async function keepControl(cell: string, fence: number): Promise<void> {
  dropControl();
  const { held, answered } = answerStamps(cell, fence);
  await answered;
  lease.value = held;
  answering.value = true;
}

/** Answers stamps for control that is asked for; resolves when the first was answered. */
export async function keepAsking(cell: string, fence: number): Promise<void> {
  dropAsking();
  const { held, answered } = answerStamps(cell, fence);
  asking.value = held;
  await answered.catch((error) => {
    if (asking.peek() === held) dropAsking();
    throw error;
  });
}

/** Control that was asked for has passed to this screen. */
export function receiveControl(): void {
  const held = asking.peek();
  if (held === null) return;
  asking.value = null;
  dropControl();
  lease.value = held;
  answering.value = true;
}

/** Asks no longer. */
export function dropAsking(): void {
  asking.peek()?.end();
  asking.value = null;
}

function answerStamps(cell: string, fence: number): { held: Lease; answered: Promise<void> } {
  const worker = new Worker(new URL('./lease-worker.ts', import.meta.url), { type: 'module' });
  const say = (message: ToLease) => worker.postMessage(message);
  const beat = window.setInterval(() => say({ kind: 'alive' }), ALIVE_MS);
  const end = () => {
    window.clearInterval(beat);
    worker.terminate();
  };
  const held: Lease = { cell, fence, stamp_s: 0, commands: 0, deniedSince_ms: null, end };
  say({ kind: 'keep', address: socketAddress(`/api/control/${cell}/lease`), fence });
  const answered = new Promise<void>((resolve, reject) => {
    const fail = () => {
      end();
      if (lease.peek() === held) dropControl();
      if (asking.peek() === held) dropAsking();
      reject(new Flaw('control-not-taken'));
    };
    const settling = window.setTimeout(fail, SETTLE_MS);
    worker.onmessage = ({ data }: MessageEvent<FromLease>) => {
      if (data.kind === 'refused') fail();
      if (lease.peek() === held) answering.value = data.kind === 'stamp';
      if (data.kind !== 'stamp') return;
      held.stamp_s = data.stamp_s;
      window.clearTimeout(settling);
      resolve();
    };
  });
  return { held, answered };
}

/** Keeps control no longer; the service notices that the stamps no longer come back. */
export function dropControl(): void {
  lease.peek()?.end();
  lease.value = null;
  answering.value = false;
}

/** Hears whose fence the service knows for the leased cell: control is somebody else's when theirs is newer, and ours no more when there is none although we answer. */
export function hearFence(fence: number | null): void {
  const held = lease.value;
  if (held === null) return;
  const denied = goesOnBeingDenied(held, fence === null && answering.value);
  if (denied || (fence !== null && fence > held.fence)) dropControl();
}

function goesOnBeingDenied(held: Lease, denied: boolean): boolean {
  if (!denied) held.deniedSince_ms = null;
  else held.deniedSince_ms ??= performance.now();
  return held.deniedSince_ms !== null && performance.now() - held.deniedSince_ms >= DENIED_MS;
}

/** Hears who asks for control: this screen does no more when the service says so again and again, as after its restart. */
export function hearRequest(fence: number | null): void {
  const held = asking.peek();
  if (held === null) return;
  if (goesOnBeingDenied(held, fence !== held.fence)) dropAsking();
}

/** The fence of this screen's control, or null. */
export function ownFence(): number | null {
  return lease.value?.fence ?? null;
}

/** What a command of whoever is in control carries. */
export function sent(): FencingToken {
  const held = lease.value;
  if (held === null) throw new Flaw('not-in-control');
  held.commands += 1;
  return { fence: held.fence, number: held.commands, stamp_s: held.stamp_s };
}
