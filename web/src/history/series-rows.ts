import type { Scatter } from '../api';
import { language } from '../session/settings';
import { INTERVAL, inOnePiece, type Quantity, scaled, scaleOf, spelt } from '../ui/units';
import type { ReadSeries } from './series';
import { type SeriesWords, seriesWords } from './series-words';

/** What a parameter is measured in. */
export function quantityOf({ name }: Pick<Scatter, 'name'>): Quantity {
  if (name === 'm') return 'mass';
  return name.startsWith('mc') ? 'moment' : 'inertia';
}

export function nameOf(parameter: string): string {
  return seriesWords.value.parameters[parameter as keyof SeriesWords['parameters']] ?? parameter;
}

/** The same as a heading. */
export function headingOf(parameter: string): string {
  const name = nameOf(parameter);
  return name.charAt(0).toLocaleUpperCase(language.value) + name.slice(1);
}

/** What the runs say together, with its interval. */
export function spelledTogether(row: Scatter): string | null {
  if (row.mean === null) return null;
  const std = row.half_width === null ? null : row.half_width / INTERVAL;
  return inOnePiece(scaled(scaleOf(quantityOf(row)), row.mean, std));
}

/** In words whether the runs agree, and where not, which of them is off. */
export function verdictOf({ answer: { series } }: ReadSeries): { agree: boolean; headline: string } {
  const said = seriesWords.value;
  const { runs, differ, apart } = series;
  if (!differ) return { agree: true, headline: said.agree(runs.length) };
  if (apart == null) return { agree: false, headline: said.scatter(runs.length) };
  const { run, parameter, difference, std } = apart;
  const shown = spelt(quantityOf({ name: parameter }), difference, std);
  return { agree: false, headline: said.apart(runs.indexOf(run) + 1, nameOf(parameter), shown) };
}

const MOST_PAIRS = 6;

/** Which two runs differ, by their numbers; null where it is said already: of two runs, of one that differs from the others. */
export function pairsApart({ answer: { series } }: ReadSeries): string | null {
  const said = seriesWords.value;
  const place = (run: string) => series.runs.indexOf(run) + 1;
  const odd = series.apart?.run;
  const apart = series.pairs.filter(({ differ, first, second }) => differ && first !== odd && second !== odd);
  if (apart.length === 0 || series.runs.length < 3) return null;
  const named = apart.slice(0, MOST_PAIRS).map(({ first, second }) => said.pair(place(first), place(second)));
  const more = apart.length - named.length;
  return said.inPairs([...named, ...(more > 0 ? [said.morePairs(more)] : [])].join(', '));
}
