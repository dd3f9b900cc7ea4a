import { computed } from '@preact/signals';
import { language } from '../session/settings';
import { isLonger } from '../words';
import { admin as de } from '../words/de-admin';
import { admin as en } from '../words/en-admin';
import { longer } from '../words/longer';

export type AdminWords = typeof en;

const CATALOGUES = { en, de };
const lengthened = isLonger && longer(en);

/** The texts of administration in the chosen language; they are loaded with its pages, which most people never open. */
export const adminWords = computed<AdminWords>(() => lengthened || CATALOGUES[language.value]);
