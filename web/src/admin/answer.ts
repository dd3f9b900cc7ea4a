import { type Signal, useSignal, useSignalEffect } from '@preact/signals';
import { every, until } from '../ui/connection';

interface Asked<T> {
  /** What the service answered last; null until it has. */
  answer: Signal<T | null>;
  /** Asks anew, after something was changed. */
  again: () => Promise<void>;
}

/** Asks the service when a section is opened, and again as often as that is said; ends with the section. */
export function useAnswer<T>(ask: () => Promise<T>, period_ms: number | null = null): Asked<T> {
  const answer = useSignal<T | null>(null);
  const again = async () => {
    answer.value = await ask();
  };
  useSignalEffect(() => (period_ms === null ? until(again) : every(period_ms, again)));
  return { answer, again };
}
