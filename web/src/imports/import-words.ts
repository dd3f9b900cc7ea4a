import type { imports } from '../words/en-imports';
import { pageWords } from '../words/page-words';

export type ImportWords = typeof imports;

/** The texts of these pages in the chosen language; they are loaded with them. */
export const importWords = pageWords(
  import.meta.glob<ImportWords>('../words/*-imports.ts', { eager: true, import: 'imports' }),
);
