import type { Vocabulary } from '.';

/** A language by its code, such as `en`: those that there are follow from the files of this folder. */
export type Language = string;

const NAME = /\/(\w+)-[\w-]+\.ts$/;
const WHOLE = import.meta.glob<Vocabulary>('./*-all.ts');

/** What there is for each language, of files `<language>-….ts` of this folder. */
export function byLanguage<T>(files: Record<string, T>): Record<Language, T> {
  return Object.fromEntries(
    Object.entries(files).map(([file, found]) => [NAME.exec(file)?.[1] ?? '', found]),
  );
}

/** All words of a language; a tablet reads one: the others are only fetched where somebody chooses them. */
export const VOCABULARIES = byLanguage(WHOLE);

/** The languages at hand, English first. */
export const LANGUAGES: readonly Language[] = Object.keys(VOCABULARIES).sort(
  (one, other) => Number(other === 'en') - Number(one === 'en') || one.localeCompare(other),
);

/** The first of the device's languages that there are words for. */
export const preferred: Language =
  navigator.languages.map(primary).find((each) => LANGUAGES.includes(each)) ?? 'en';

/** What a language calls itself. */
export function nameOf(language: Language): string {
  const name = new Intl.DisplayNames([language], { type: 'language' }).of(language) ?? language;
  return name.charAt(0).toLocaleUpperCase(language) + name.slice(1);
}

function primary(tag: string): string {
  return tag.split('-')[0]?.toLowerCase() ?? '';
}
