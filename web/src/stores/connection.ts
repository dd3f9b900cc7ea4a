import { signal, untracked } from '@preact/signals';

/** Whether the service answered last time. */
export const connected = signal(true);

/** Asks again and again while somebody looks; returns what ends it. */
export function every(period_ms: number, ask: () => Promise<void>): () => void {
  let timer = 0;
  let ended = false;
  const round = async (): Promise<void> => {
    window.clearTimeout(timer);
    await ask().catch(() => undefined); // the client has noted a lost connection; the next round asks again
    if (!ended) timer = window.setTimeout(round, period_ms);
  };
  void untracked(round);
  window.addEventListener('online', round);
  return () => {
    ended = true;
    window.clearTimeout(timer);
    window.removeEventListener('online', round);
  };
}
