import { signal } from '@preact/signals';
import { Refusal } from '../client';

/** What went wrong last, as a sentence; empty where nothing did, or it was read. */
export const notice = signal('');

/** Does what a person asked for; a refusal becomes the notice. */
export async function attempt(act: () => Promise<void>): Promise<void> {
  notice.value = '';
  try {
    await act();
  } catch (error) {
    notice.value = error instanceof Error ? error.message : String(error);
  }
}

/** A no becomes the notice; whatever else went wrong is thrown on. */
export function told(error: unknown): null {
  if (!(error instanceof Refusal)) throw error;
  notice.value = error.message;
  return null;
}
