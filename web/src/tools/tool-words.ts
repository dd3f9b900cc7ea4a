import { computed } from '@preact/signals';
import { language } from '../session/settings';
import { isLonger } from '../words';
import { tools as de } from '../words/de-tools';
import { tools as en } from '../words/en-tools';
import { loadMessages } from '../words/later-messages';
import { longer } from '../words/longer';

export type ToolWords = typeof en;

const CATALOGUES = { en, de };
const lengthened = isLonger && longer(en);

/** The texts of the tool library in the chosen language; they are loaded with its page and its form. */
export const toolWords = computed<ToolWords>(() => lengthened || CATALOGUES[language.value]);

loadMessages('library');
