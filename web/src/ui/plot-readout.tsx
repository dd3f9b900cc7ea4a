import type UPlot from 'uplot';
import { words } from '../words';
import { type Line, nameOf } from './plot-line';
import type { Since } from './plot-options';
import { moment, number } from './units';

const DIGITS = 4;

interface Props {
  plot: { current: UPlot | null };
  /** Where the crosshair is. */
  row: number | null;
  lines: Line[];
  hidden: readonly string[];
  unit: string;
  since: Since;
}

/** The values at the crosshair, with their unit. */
export function PlotReadout({ plot, row, lines, hidden, unit, since }: Props) {
  const data = plot.current?.data;
  const t_s = row === null ? undefined : data?.[0][row];
  if (row === null || data === undefined || t_s === undefined) return null;
  const told = lines.flatMap((line, k) => {
    const value = data[k + 1]?.[row];
    const shown = !hidden.includes(line.label.replace(/^_/, '')) && isNamed(line);
    return shown && value != null ? [{ line, value }] : [];
  });
  return (
    <dl class="readout" aria-label={words.value.charts.crosshair}>
      <dt>{since === 'run' ? `${number(t_s, 2)} s` : moment(new Date(1000 * t_s).toISOString())}</dt>
      {told.map(({ line, value }) => (
        <dd key={line.label} style={{ '--key': `var(${line.colour})` }}>
          {nameOf(line)} <b>{number(value, placesOf(value))}</b> {unit}
        </dd>
      ))}
    </dl>
  );
}

/** One without a name is only there to be drawn. */
function isNamed({ label, name }: Line): boolean {
  return name !== undefined || !label.startsWith('_');
}

function placesOf(value: number): number {
  return value === 0 ? 0 : Math.min(6, Math.max(0, DIGITS - 1 - Math.floor(Math.log10(Math.abs(value)))));
}
