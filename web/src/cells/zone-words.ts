import type { zones } from '../words/en-zones';
import { pageWords } from '../words/page-words';

/** The texts of the zones' editor in the chosen language; they are loaded with the page of the cells. */
export const zoneWords = pageWords(
  import.meta.glob<typeof zones>('../words/*-zones.ts', { eager: true, import: 'zones' }),
);
