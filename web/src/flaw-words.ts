import { words } from './words';

const HOLE = '{}';

/** A phrase about a flaw in the chosen language; undefined where its catalogue has no words for it. */
export function flawSaid(english: string): string | undefined {
  for (const [pattern, said] of specificFirst(words.value.flaws)) {
    const named = new RegExp(`^${pattern.split(HOLE).map(literally).join('(.*)')}$`, 's').exec(english);
    if (named) return filled(said, named.slice(1));
  }
  return undefined;
}

/** A phrase that says more itself comes before one that leaves more open. */
function specificFirst(flaws: Record<string, string>): [string, string][] {
  const saysItself = (pattern: string) => pattern.replaceAll(HOLE, '').length;
  return Object.entries(flaws).sort(([one], [other]) => saysItself(other) - saysItself(one));
}

const literally = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

function filled(said: string, named: string[]): string {
  return said.split(HOLE).reduce((before, after, k) => before + named[k - 1] + after);
}
