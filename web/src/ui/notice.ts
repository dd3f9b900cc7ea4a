import { signal } from '@preact/signals';
import type { Flaw as FileFlaw } from '../api';
import { Refusal } from './refusal';

/** What went wrong: its kind, a sentence about it in English, and what of a file or of what was asked for cannot be used. */
export interface Notice {
  kind: string | null;
  english: string;
  flaws?: FileFlaw[] | undefined;
}

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
  notice.value = noticeOf(error);
  return null;
}

/** What goes wrong on this screen alone, by its kind in the catalogue. */
export class Flaw extends Error {
  constructor(readonly kind: string) {
    super(kind);
  }
}

function noticeOf(error: unknown): Notice {
  if (error instanceof Flaw) return { kind: error.kind, english: '' };
  if (error instanceof Refusal) {
    const { type, detail, flaws } = error.problem;
    return { kind: type.split('/').at(-1) ?? null, english: detail, flaws };
  }
  const unreachable =
    error instanceof TypeError || (error instanceof DOMException && error.name === 'TimeoutError');
  return unreachable ? { kind: 'unreachable', english: '' } : { kind: null, english: String(error) };
}
