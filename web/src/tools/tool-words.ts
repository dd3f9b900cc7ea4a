import type { tools } from '../words/en-tools';
import { pageWords } from '../words/page-words';

export type ToolWords = typeof tools;

/** The texts of the tool library in the chosen language; they are loaded with its page and its form. */
export const toolWords = pageWords(
  import.meta.glob<ToolWords>('../words/*-tools.ts', { eager: true, import: 'tools' }),
);
