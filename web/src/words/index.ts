import { computed } from '@preact/signals';
import { type Language, language } from '../session/settings';
import { de } from './de';
import { en, type Words } from './en';
import { longer } from './longer';

const CATALOGUES: Record<Language, Words> = { en, de };

/** `?words=longer` in the address shows how the console looks in a language with longer words than English. */
export const LONGER = new URLSearchParams(location.search).get('words') === 'longer' ? longer(en) : null;

/** Every text of the console in the chosen language. */
export const words = computed<Words>(() => LONGER ?? CATALOGUES[language.value]);
