import { route, to } from '../ui/route';
import { words } from '../words';
import { openAlarms, unseen } from './alarms';

/** How many alarms are open, on every page; marked while nobody has acknowledged one of them. */
export function Bell() {
  const count = openAlarms.value?.length ?? 0;
  const marked = unseen.value.some(({ severity }) => severity !== 'low');
  return (
    <a
      class={marked ? 'bell bell-marked' : 'bell'}
      href={to('alarms')}
      aria-label={words.value.alarms.bell(count)}
      aria-current={route.value[0] === 'alarms' ? 'page' : undefined}
    >
      <svg viewBox="0 0 32 32" aria-hidden="true">
        <path d="M16 4a8 8 0 0 0-8 8v7l-3 4h22l-3-4v-7a8 8 0 0 0-8-8zM13 26a3 3 0 0 0 6 0" />
      </svg>
      <b>{count}</b>
    </a>
  );
}
