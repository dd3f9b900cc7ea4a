/** How much longer than English a language may be. */
const SHARE = 0.4;

/** The same catalogue with every word that much longer, to see whether screens have room for languages that are yet to come. */
export function longer<T>(words: T): T {
  if (typeof words === 'string') return lengthen(words) as T;
  if (typeof words === 'function') return ((...given: unknown[]) => lengthen(words(...given))) as T;
  if (Array.isArray(words)) return words.map(longer) as T;
  return Object.fromEntries(Object.entries(words as object).map(([key, each]) => [key, longer(each)])) as T;
}

/** A text with every word that much longer. */
export function lengthen(text: string): string {
  return text.replace(/\p{L}+/gu, (word) => word + 'ë'.repeat(Math.round(SHARE * word.length)));
}
