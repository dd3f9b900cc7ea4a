import { computed } from '@preact/signals';
import { number } from '../ui/units';
import { words } from '.';

const HOLE = '{}';
/** What somebody called something, or a list of it: no words of the engine's. */
const VALUE = /^('[^']*'|"[^"]*"|\[.*\])$/s;

/** A phrase that the engine may say, its words between the holes, and how the chosen language says it. */
interface Phrase {
  words: string[];
  said: string;
}

/** One that says more itself comes before one that leaves more open. */
const phrases = computed<Phrase[]>(() => {
  const { flaws, sentences, leftOut } = words.value;
  const ownLetters = ({ words: own }: Phrase) => own.join('').length;
  return Object.entries({ ...flaws, ...sentences, ...leftOut })
    .map(([english, said]) => ({ words: english.split(HOLE), said }))
    .sort((one, other) => ownLetters(other) - ownLetters(one));
});

/** What the engine says, in the chosen language; undefined where its catalogue has no words for it. */
export function engineSaid(english: string): string | undefined {
  if (VALUE.test(english)) return undefined;
  for (const phrase of phrases.value) {
    const named = holes(phrase.words, english);
    if (named) return filled(phrase.said, named.map(partSaid));
  }
  return undefined;
}

/** What stands between these words, each where it comes first; null where they do not make up the text. */
function holes([first = '', ...others]: string[], text: string): string[] | null {
  const last = others.pop();
  if (last === undefined) return text === first ? [] : null;
  const end = text.length - last.length;
  if (!text.startsWith(first) || !text.endsWith(last)) return null;
  const found: string[] = [];
  let at = first.length;
  for (const word of others) {
    const next = text.indexOf(word, at);
    if (next < 0) return null;
    found.push(text.slice(at, next));
    at = next + word.length;
  }
  return at > end ? null : [...found, text.slice(at, end)];
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
