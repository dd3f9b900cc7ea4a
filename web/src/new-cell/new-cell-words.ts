import { computed } from '@preact/signals';
import { language } from '../session/settings';
import { isLonger } from '../words';
import { newCell as de } from '../words/de-new-cell';
import { newCell as en } from '../words/en-new-cell';
import { loadMessages } from '../words/later-messages';
import { longer } from '../words/longer';

export type NewCellWords = typeof en;

const CATALOGUES = { en, de };
const lengthened = isLonger && longer(en);

/** The texts of these pages in the chosen language; they are loaded with them. */
export const newCellWords = computed<NewCellWords>(() => lengthened || CATALOGUES[language.value]);

loadMessages('drafts', 'newcell');
