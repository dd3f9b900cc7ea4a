import { signal } from '@preact/signals';

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
