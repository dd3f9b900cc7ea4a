import { signal } from '@preact/signals';
import { Refusal } from '../refusal';

/** What went wrong: its kind, and a sentence about it in English. */
export interface Notice {
  kind: string | null;
  english: string;
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
  if (error instanceof Refusal)
    return { kind: error.problem.type.split('/').at(-1) ?? null, english: error.message };
  const unreachable =
    error instanceof TypeError || (error instanceof DOMException && error.name === 'TimeoutError');
  return unreachable ? { kind: 'unreachable', english: '' } : { kind: null, english: String(error) };
}
