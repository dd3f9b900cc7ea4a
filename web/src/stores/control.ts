import { computed, effect, signal } from '@preact/signals';
import type { ControlAnswer, Sent } from '../api';
import { ask, socketAddress } from '../client';
import type { FromLease, ToLease } from '../lease-worker';
import { chosenCell } from './cells';
import { every } from './connection';
import { nameOf } from './names';
import { Flaw } from './notice';
import { session } from './session';

const ALIVE_MS = 250;
const ASK_MS = 1000;

/** Who is in control of the chosen cell, as the service said last. */
export const control = signal<ControlAnswer | null>(null);

interface Lease {
  cell: string;
  fence: number;
  stamp_s: number;
  commands: number;
  end: () => void;
}

const lease = signal<Lease | null>(null);
/** Whether it is this very screen that is in control of the chosen cell. */
export const mine = computed(() => lease.value !== null && lease.value.cell === chosenCell.value);
/** Somebody's name, or null where nobody is in control. */
export const holder = computed(() => (control.value?.holder ? nameOf(control.value.holder) : null));

/** Takes control; resolves when the first stamp was answered. */
export async function takeControl(cell: string): Promise<void> {
  letGo();
  const taken = await ask('POST /api/control', { body: { cell } });
  if (taken.fence === null) throw new Flaw('control-not-taken');
  lease.value = await begun(cell, taken.fence);
  control.value = taken;
}

/** Lets go of control; the service notices that the stamps no longer come back. */
export function letGo(): void {
  lease.value?.end();
  lease.value = null;
}

/** What a command of whoever is in control carries. */
export function sent(): Sent {
  const held = lease.value;
  if (held === null) throw new Flaw('not-in-control');
  held.commands += 1;
  return { fence: held.fence, number: held.commands, stamp_s: held.stamp_s };
}

/** Control that is kept from its first answered stamp on. */
function begun(cell: string, fence: number): Promise<Lease> {
  const worker = new Worker(new URL('../lease-worker.ts', import.meta.url), { type: 'module' });
  const say = (message: ToLease) => worker.postMessage(message);
  const beat = window.setInterval(() => say({ kind: 'alive' }), ALIVE_MS);
  const end = () => {
    window.clearInterval(beat);
    worker.terminate();
  };
  const held: Lease = { cell, fence, stamp_s: 0, commands: 0, end };
  say({ kind: 'keep', address: socketAddress(`/api/control/${cell}/lease`), fence });
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<FromLease>) => {
      if (data.kind === 'stamp') {
        held.stamp_s = data.stamp_s;
        resolve(held);
        return;
      }
      end();
      if (lease.value === held) lease.value = null;
      reject(new Flaw('control-not-taken'));
    };
  });
}

effect(() => {
  const name = chosenCell.value;
  control.value = null;
  if (!session.value || !name) return undefined;
  return every(ASK_MS, async () => {
    control.value = await ask('GET /api/control/{cell}', { path: { cell: name } });
    const { fence } = control.value; // null where stamps were late: control comes back with the next one
    if (lease.value !== null && fence !== null && fence !== lease.value.fence) letGo();
  });
});
effect(() => {
  if (session.value === null) letGo();
});
