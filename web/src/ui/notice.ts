import { signal } from '@preact/signals';
import { words } from '../words';
import type { Message } from '../words/catalogue';
import type { mishaps } from '../words/en-mishaps';
import { quote } from '../words/messages';
import { Refusal } from './refusal';

/** What can go wrong on this screen alone. */
export type Mishap = keyof typeof mishaps;

/** What went wrong: on this screen, or what the service says. */
export type Notice = Mishap | Message;

/** What went wrong last; null where nothing did, or it was read. */
export const notice = signal<Notice | null>(null);

/** Does what a person asked for; a refusal becomes the notice. */
export async function attempt(act: () => Promise<void>): Promise<void> {
  notice.value = null;
  try {
    await act();
  } catch (error) {
    notice.value = noticeOf(error);
  }
}

/** A no becomes the notice; whatever else went wrong is thrown on. */
export function told(error: unknown): null {
  if (!(error instanceof Refusal)) throw error;
  notice.value = error.said;
  return null;
}

/** What goes wrong on this screen alone. */
export class Flaw extends Error {
  constructor(readonly mishap: Mishap) {
    super(mishap);
  }
}

/** It as a message, in the chosen language where it is this screen's own. */
export function messageOf(shown: Notice): Message {
  return typeof shown === 'string' ? quote(words.value.mishaps[shown]) : shown;
}

/** What an error says. */
export function noticeOf(error: unknown): Notice {
  if (error instanceof Flaw) return error.mishap;
  if (error instanceof Refusal) return error.said;
  const unreachable =
    error instanceof TypeError || (error instanceof DOMException && error.name === 'TimeoutError');
  return unreachable ? 'unreachable' : quote(String(error));
}
