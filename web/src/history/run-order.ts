import { computed } from '@preact/signals';
import type { RunPublic } from '../api';
import { filters, setFilter } from '../ui/route';
import { identifiersOf } from './run-text';

/** What runs can be sorted by. */
const KEYS = {
  run: ({ ended_at, requested_at }: RunPublic) => ended_at ?? requested_at,
  tool: ({ payload }: RunPublic) => payload ?? '',
  serial_number: (run: RunPublic) => identifiersOf(run).serial_number,
  order_id: (run: RunPublic) => identifiersOf(run).order_id || identifiersOf(run).work_order,
  mass: ({ result }: RunPublic) => result?.mass_kg ?? null,
  found: ({ state }: RunPublic) => state,
};

export type Column = keyof typeof KEYS;

interface Order {
  column: Column;
  /** Smallest, earliest first. */
  rises: boolean;
}

/** The newest first, where the address says nothing else. */
export const order = computed<Order>(() => {
  const [column = '', direction] = (filters.value.get('sort') ?? '').split('.');
  return column in KEYS
    ? { column: column as Column, rises: direction === 'up' }
    : { column: 'run', rises: false };
});

/** Sorts by a column; the other way round where that is so already. */
export function sortBy(column: Column): void {
  const rises = order.value.column === column ? !order.value.rises : column !== 'run';
  setFilter('sort', column === 'run' && !rises ? '' : `${column}.${rises ? 'up' : 'down'}`);
}

/** Runs in the chosen order, equals as they came; those without what they are sorted by come last. */
export function sorted(runs: RunPublic[]): RunPublic[] {
  const { column, rises } = order.value;
  const key = KEYS[column];
  const has = (run: RunPublic) => key(run) !== null && key(run) !== '';
  const way = rises ? 1 : -1;
  const inOrder = runs.filter(has).sort((one, other) => way * compare(key(one), key(other)));
  return [...inOrder, ...runs.filter((run) => !has(run))];
}

/** Numbers by size, texts as people count: part 9 before part 10. */
function compare(one: string | number | null, other: string | number | null): number {
  if (typeof one === 'number' && typeof other === 'number') return one - other;
  return String(one).localeCompare(String(other), undefined, { numeric: true });
}
