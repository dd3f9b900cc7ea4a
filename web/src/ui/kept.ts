import { effect, type Signal, signal } from '@preact/signals';

/** A signal that this browser keeps; what it kept is taken only where `known` holds. */
export function kept<T extends string>(key: string, begin: T, known: (text: string) => text is T): Signal<T> {
  const before = localStorage.getItem(`heft.${key}`);
  const found = signal<T>(before !== null && known(before) ? before : begin);
  effect(() => localStorage.setItem(`heft.${key}`, found.value));
  return found;
}

/** Whether a text is one of a list. */
export function oneOf<T extends string>(list: readonly T[]): (text: string) => text is T {
  return (text): text is T => (list as readonly string[]).includes(text);
}
