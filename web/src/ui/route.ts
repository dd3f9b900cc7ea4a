import { computed, signal } from '@preact/signals';

/** The part of the address behind `#`, as its pieces: `#/runs/01a1` is ["runs", "01a1"]. */
export const route = signal(pieces());

function pieces(): string[] {
  const [path = ''] = location.hash.replace(/^#\/?/, '').split('?');
  return path.split('/').filter(Boolean).map(decoded);
}

/** What cannot be decoded names nothing that is there; it is shown as it stands. */
function decoded(piece: string): string {
  try {
    return decodeURIComponent(piece);
  } catch {
    return piece;
  }
}

/** What the address says of a page besides: `#/history?tool=gripper`. */
export const filters = signal(readFilters());

function readFilters(): URLSearchParams {
  return new URLSearchParams(location.hash.split('?')[1]);
}

/** Writes a filter into the address of this page, without a step of its own to go back to; an empty one is taken out. */
export function setFilter(name: string, value: string): void {
  const changed = new URLSearchParams(filters.value);
  if (value) changed.set(name, value);
  else changed.delete(name);
  const [path = ''] = location.hash.split('?');
  history.replaceState(null, '', changed.size > 0 ? `${path}?${changed}` : path);
  filters.value = changed;
}

window.addEventListener('hashchange', () => {
  route.value = pieces();
  filters.value = readFilters();
});

/** The address of a page in this console. */
export function to(...parts: string[]): string {
  return `#/${parts.map(encodeURIComponent).join('/')}`;
}

export function go(...parts: string[]): void {
  location.hash = to(...parts);
}

/** The run that the address names. */
export const runInRoute = computed(() => (route.value[0] === 'runs' ? (route.value[1] ?? null) : null));
