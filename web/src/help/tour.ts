import { computed, effect, signal } from '@preact/signals';
import { robots } from '../run/now';
import { session } from '../session/session';
import { kept } from '../ui/kept';
import { helpOpen } from './help';

const NAMES = /^[\w, -]*$/;

/** Who has seen the tour on this browser, by the names of their accounts. */
const seen = kept('tour', '', (text): text is string => NAMES.test(text));

/** Which step is shown, from 0 on; null while nobody takes the tour. */
export const touring = signal<number | null>(null);

/** Nobody is led through screens while a robot moves. */
export const mayTour = computed(() => session.value != null && !robots.value?.some(({ moving }) => moving));

/** Whether it is offered to who is signed in: until they have taken it, or said that they need none. */
export const isOffered = computed(
  () => mayTour.value && touring.value === null && !names().includes(session.value?.name ?? ''),
);

export function startTour(): void {
  if (!mayTour.peek()) return;
  helpOpen.value = false;
  touring.value = 0;
}

/** It is over, or was not wanted; it is not offered to this person again. */
export function endTour(): void {
  const name = session.peek()?.name;
  touring.value = null;
  if (name && !names().includes(name)) seen.value = [...names(), name].join(',');
}

effect(() => {
  if (!mayTour.value && touring.value !== null) endTour();
});

function names(): string[] {
  return seen.value.split(',').filter(Boolean);
}
