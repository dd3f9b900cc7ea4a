import { computed, signal } from '@preact/signals';
import { run } from '../run/run';
import { session } from '../session/session';
import { route } from '../ui/route';

/** Every kind of screen that there is something to say about. */
export type Topic =
  | 'signIn'
  | 'setup'
  | 'plan'
  | 'running'
  | 'result'
  | 'ended'
  | 'orders'
  | 'gap'
  | 'trials'
  | 'history'
  | 'cells'
  | 'alarms'
  | 'control'
  | 'settings'
  | 'admin'
  | 'manual';

const OF_PAGES = new Set<string>([
  'orders',
  'gap',
  'trials',
  'history',
  'cells',
  'alarms',
  'control',
  'settings',
  'admin',
  'manual',
]);
const OF_STATES: Partial<Record<string, Topic>> = {
  Resetting: 'plan',
  Idle: 'plan',
  Complete: 'result',
  Stopped: 'ended',
  Aborted: 'ended',
  Clearing: 'ended',
};

/** Whether the help is open. */
export const helpOpen = signal(false);

/** What is on this screen. */
export const topic = computed<Topic>(() => {
  const [page = ''] = route.value;
  if (!session.value) return 'signIn';
  if (page === 'runs') return (run.value && OF_STATES[run.value.state]) ?? 'running';
  if (page === 'series' || page === 'timeline') return 'history';
  if (page === 'import') return 'gap';
  return OF_PAGES.has(page) ? (page as Topic) : 'setup';
});
