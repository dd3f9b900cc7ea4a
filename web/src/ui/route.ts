import { computed, signal } from '@preact/signals';

/** The part of the address behind `#`, as its pieces: `#/runs/01a1` is ["runs", "01a1"]. */
export const route = signal(pieces());

function pieces(): string[] {
  return location.hash.replace(/^#\/?/, '').split('/').filter(Boolean).map(decoded);
}

/** What cannot be decoded names nothing that is there; it is shown as it stands. */
function decoded(piece: string): string {
  try {
    return decodeURIComponent(piece);
  } catch {
    return piece;
  }
}

window.addEventListener('hashchange', () => {
  route.value = pieces();
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
