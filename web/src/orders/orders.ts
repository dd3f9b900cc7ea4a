import { effect, signal, untracked } from '@preact/signals';
import type { OrderPublic } from '../api';
import { session } from '../session/session';
import { ask } from '../ui/client';
import { hearAll } from '../ui/socket';

/** What is queued, of every cell, as the service said last; null until it is known. */
export const orders = signal<OrderPublic[] | null>(null);

/** Takes an order back that has not been released; who sent it gets to know why. */
export async function cancelOrder(run: string, why: string): Promise<void> {
  await ask('DELETE /api/runs/{run}', { path: { run }, query: why === '' ? {} : { why } });
}

effect(() => {
  orders.value = null;
  if (!session.value) return undefined;
  return untracked(() =>
    hearAll<{ at: string; orders: OrderPublic[] | null }>('/api/orders/live', (said) => {
      if (said.orders !== null) orders.value = said.orders;
    }),
  );
});
