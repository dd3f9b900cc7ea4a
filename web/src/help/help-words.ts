import type { help } from '../words/en-help';
import { pageWords } from '../words/page-words';

/** The texts of help and tour in the chosen language; they come with the first of them. */
export const helpWords = pageWords(
  import.meta.glob<typeof help>('../words/*-help.ts', { eager: true, import: 'help' }),
);
