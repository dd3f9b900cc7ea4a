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

/** Something that is told and refuses nothing: it passes by itself, or stays until it was read. */
export interface Remark {
  id: number;
  text: () => string;
  kind: 'passes' | 'stays';
}

/** How long what passes by itself is to be seen: long enough to be read twice. */
const SEEN_MS = 8000;
/** More at a time would hide the page; of those the older ones go. */
const MOST = 3;
let remarked = 0;

/** What was told and is still to be seen, oldest first. */
export const remarks = signal<Remark[]>([]);

/** Tells something, in whatever language is chosen by then. */
export function say(text: () => string, kind: Remark['kind']): void {
  remarked += 1;
  const id = remarked;
  remarks.value = [...remarks.peek(), { id, text, kind }].slice(-MOST);
  if (kind === 'passes') window.setTimeout(() => dismiss(id), SEEN_MS);
}

/** It was read, or has been there for long enough. */
export function dismiss(id: number): void {
  remarks.value = remarks.peek().filter((each) => each.id !== id);
}

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
