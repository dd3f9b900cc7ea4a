import { signal, untracked } from '@preact/signals';
import { Refusal } from '../refusal';

/** Whether the service answered last time. */
export const connected = signal(true);

const RETRY_MS = 1000;

/** Asks again and again while somebody looks; returns what ends it. */
export function every(period_ms: number, ask: () => Promise<void>): () => void {
  return asked(ask, () => period_ms);
}

/** Asks until there is an answer, be it a no; returns what ends it. */
export function until(ask: () => Promise<void>): () => void {
  return asked(ask, (answered) => (answered ? null : RETRY_MS));
}

function asked(ask: () => Promise<void>, again_ms: (answered: boolean) => number | null): () => void {
  let timer = 0;
  let turn = 0;
  const round = async (): Promise<void> => {
    window.clearTimeout(timer);
    turn += 1;
    const mine = turn;
    const answered = await ask().then(
      () => true,
      (error) => error instanceof Refusal,
    );
    if (mine !== turn) return;
    const next_ms = again_ms(answered);
    if (next_ms === null) leave();
    else timer = window.setTimeout(round, next_ms);
  };
  const leave = () => {
    turn += 1;
    window.clearTimeout(timer);
    window.removeEventListener('online', round);
  };
  void untracked(round);
  window.addEventListener('online', round);
  return leave;
}
