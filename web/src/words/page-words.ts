import { computed, type ReadonlySignal } from '@preact/signals';
import { language } from '../session/settings';
import { isLonger } from '.';
import { byLanguage } from './languages';
import { longer } from './longer';

/**
 * Texts that come with a page which most people never open, in the chosen language.
 *
 * @param files of every language, by their names: `import.meta.glob('../words/*-<page>.ts', { eager: true, import: … })`.
 */
export function pageWords<T>(files: Record<string, T>): ReadonlySignal<T> {
  const texts = byLanguage(files);
  const english = texts.en;
  if (english === undefined) throw new Error('these texts have no English');
  const lengthened = isLonger ? longer(english) : null;
  return computed(() => lengthened ?? texts[language.value] ?? english);
}
