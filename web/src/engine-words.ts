import { computed } from '@preact/signals';
import { number } from './units';
import { words } from './words';

const HOLE = '{}';

/** A phrase that the engine may say, and how the chosen language says it. */
interface Phrase {
  english: RegExp;
  said: string;
}

/** One that says more itself comes before one that leaves more open. */
const phrases = computed<Phrase[]>(() => {
  const { flaws, sentences } = words.value;
  const ownLetters = (pattern: string) => pattern.replaceAll(HOLE, '').length;
  return Object.entries({ ...flaws, ...sentences })
    .sort(([one], [other]) => ownLetters(other) - ownLetters(one))
    .map(([pattern, said]) => ({ english: matching(pattern), said }));
});

function matching(pattern: string): RegExp {
  const literally = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  return new RegExp(`^${pattern.split(HOLE).map(literally).join('(.*)')}$`, 's');
}

/** What the engine says, in the chosen language; undefined where its catalogue has no words for it. */
export function engineSaid(english: string): string | undefined {
  for (const phrase of phrases.value) {
    const named = phrase.english.exec(english);
    if (named) return filled(phrase.said, named.slice(1).map(partSaid));
  }
  return undefined;
}

/** What a phrase names: a number, a phrase itself, several with commas between them, or a value. */
function partSaid(part: string): string {
  const [, decimals] = /^-?\d+\.(\d+)$/.exec(part) ?? [];
  if (decimals !== undefined) return number(Number(part), decimals.length);
  return engineSaid(part) ?? part.split(', ').map(itemSaid).join(', ');
}

const itemSaid = (item: string) => engineSaid(item) ?? item;

function filled(said: string, named: string[]): string {
  return said.split(HOLE).reduce((before, after, k) => before + named[k - 1] + after);
}
