import { computed, effect, signal } from '@preact/signals';
import { Refusal } from './refusal';
import { route, to } from './route';

const NOT_FOUND = 404;

const address = computed(() => to(...route.value));
const emptyAddress = signal('');

/** Whether the service has said that what the address names is not there. */
export const absent = computed(() => emptyAddress.value === address.value);

effect(() => {
  if (address.value) emptyAddress.value = '';
});

/** Reads what the address names; that it is not there is kept for as long as the address stays. */
export async function sought<T>(reading: Promise<T>): Promise<T> {
  const asked = address.peek();
  return reading.catch((error) => {
    const missing = error instanceof Refusal && error.problem.status === NOT_FOUND;
    if (missing && asked === address.peek()) emptyAddress.value = asked;
    throw error;
  });
}
