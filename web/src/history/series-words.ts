import type { series } from '../words/en-series';
import { pageWords } from '../words/page-words';

export type SeriesWords = typeof series;

/** The texts of a series in the chosen language; they are loaded with its page. */
export const seriesWords = pageWords(
  import.meta.glob<SeriesWords>('../words/*-series.ts', { eager: true, import: 'series' }),
);
