import type { newCell } from '../words/en-new-cell';
import { pageWords } from '../words/page-words';

export type NewCellWords = typeof newCell;

/** The texts of these pages in the chosen language; they are loaded with them. */
export const newCellWords = pageWords(
  import.meta.glob<NewCellWords>('../words/*-new-cell.ts', { eager: true, import: 'newCell' }),
);
