import { computed, effect, type Signal, signal, untracked } from '@preact/signals';
import type { JobStatus } from '../api';
import { session } from '../session/session';
import { absent, sought } from './absent';
import { every } from './connection';
import { route } from './route';

interface Job {
  state: JobStatus;
}

export const ASK_JOB_MS = 1000;
const ASK_LIST_MS = 3000;

/** Whether a job is not over yet. */
export function isUnderWay({ state }: Job): boolean {
  return state === 'waiting' || state === 'running';
}

export interface Jobs<J> {
  /** The newest, without their results; null until they are known. */
  listed: Signal<J[] | null>;
  /** The one that the address names, as it stands; null until it is known. */
  shown: Signal<J | null>;
}

/** Jobs of the kind that a page of the console is about: all of them at `#/page`, one at `#/page/id`. */
export function jobsOf<J extends Job>(
  page: string,
  list: () => Promise<J[]>,
  read: (id: string) => Promise<J>,
): Jobs<J> {
  const listed = signal<J[] | null>(null);
  const shown = signal<J | null>(null);
  const here = computed(() => session.value != null && route.value[0] === page);
  const id = computed(() => (here.value ? (route.value[1] ?? '') : null));
  const readListed = async () => {
    listed.value = await list();
  };
  const readShown = async (named: string) => {
    if (shown.value !== null && !isUnderWay(shown.value)) return;
    const found = await sought(read(named));
    if (id.value === named) shown.value = found;
  };
  effect(() => {
    const named = id.value;
    untracked(() => {
      shown.value = null;
    });
    if (named === null || absent.value) return undefined;
    return named ? every(ASK_JOB_MS, () => readShown(named)) : every(ASK_LIST_MS, readListed);
  });
  return { listed, shown };
}
