import type UPlot from 'uplot';
import type { Line } from './plot-line';
import { extentOf } from './plot-zoom';
import { dateLocale, number } from './units';

export type Since = 'run' | '1970';

const AXIS_PX = 56;
const TICK_PX = 32;
/** However low a plot is, there are about so many. */
const FEWEST_TICKS = 2;
const DIGIT_PX = 9;
const DECIMALS = [0, 1, 2, 3, 4, 5, 6];
const SECONDS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60];
const DAY_S = 86_400;
const LEAST_S = 3600;
const FONT = '14px system-ui, sans-serif';
const DRAG_PX = 8;

interface Told {
  /** The crosshair is at this row, or nowhere. */
  point: (row: number | null) => void;
  /** What is shown of the time is another part. */
  scale: (plot: UPlot) => void;
}

/** How a plot looks, and what it tells of what is done to it. */
export function optionsOf(
  place: HTMLElement,
  lines: Line[],
  bands: [number, number][],
  since: Since,
  together: string | undefined,
  told: Told,
): Omit<UPlot.Options, 'width' | 'height'> {
  const colour = (name: string) => coloured(place, name);
  const axis = {
    stroke: () => colour('--ink'),
    grid: { stroke: () => colour('--line-faint'), width: 1 },
    ticks: { show: false },
    font: FONT,
  };
  return {
    legend: { show: false },
    cursor: {
      drag: { x: true, y: false, dist: DRAG_PX },
      ...(together === undefined ? {} : { sync: { key: together, setSeries: false } }),
    },
    scales: { x: since === 'run' ? { time: false } : { time: true, range: roomy } },
    axes: [
      { ...axis, ...TIMES[since] },
      {
        ...axis,
        size: (_plot, texts) =>
          Math.max(AXIS_PX, DIGIT_PX * Math.max(...(texts ?? []).map((text) => text.length)) + 12),
        space: (_plot, _axis, _least, _most, height) => Math.min(TICK_PX, height / FEWEST_TICKS),
        values: (_plot, ticks, _axis, _space, step) => ticks.map((value) => number(value, decimalsOf(step))),
      },
    ],
    series: [
      {},
      ...lines.map(({ label, colour: name, dashed, drawn }) => ({
        label,
        stroke: () => colour(name),
        width: 2,
        dash: dashed ? [6, 5] : [],
        ...(drawn ? { paths: drawn === 'bars' ? bars : () => null } : {}),
        points: { show: drawn === 'dots', size: 10, fill: () => colour(name) },
      })),
    ],
    bands: bands.map((series) => ({ series, fill: () => colour('--band') })),
    hooks: {
      draw: [({ data: [times] }) => note(place, times.at(-1))],
      setCursor: [({ cursor }) => told.point(cursor.idx ?? null)],
      setScale: [(plot, scale) => scale === 'x' && told.scale(plot)],
    },
  };
}

/** What a plot shows reaches up to here; by this the time from a sample to the screen is measured (bench/screen_latency.py). */
function note(place: HTMLElement, newest_s: number | undefined): void {
  place.dataset.drawnUpTo = String(newest_s);
}

/** The axis of time: seconds of a run, or days and times of day; the day stands at its first tick. */
const TIMES: Record<Since, UPlot.Axis> = {
  run: {
    size: 28,
    incrs: SECONDS,
    values: (_plot, ticks, _axis, _space, step_s) => ticks.map((t) => `${number(t, decimalsOf(step_s))} s`),
  },
  '1970': { size: 48, space: 90, values: (_plot, ticks, _axis, _space, step) => datesOf(ticks, step) },
};

/** Upright bars between the values of one line and the next. */
function bars(plot: UPlot, line: number): UPlot.Series.Paths {
  const path = new Path2D();
  const [times, from = [], to = []] = [plot.data[0], plot.data[line], plot.data[line + 1]];
  times.forEach((t_s, k) => {
    const [low, high] = [from[k], to[k]];
    if (low == null || high == null) return;
    const x = plot.valToPos(t_s, 'x', true);
    path.moveTo(x, plot.valToPos(low, 'y', true));
    path.lineTo(x, plot.valToPos(high, 'y', true));
  });
  return { stroke: path };
}

/** From a little before the first moment to a little after the last, and an hour at least; a part of it as it was chosen. */
function roomy({ data }: UPlot, from_s: number, to_s: number): [number, number] {
  const [first_s, last_s] = extentOf(data);
  if (from_s > first_s || to_s < last_s) return [from_s, to_s];
  const room_s = Math.max(0.05 * (last_s - first_s), (LEAST_S - (last_s - first_s)) / 2);
  return [first_s - room_s, last_s + room_s];
}

function datesOf(ticks: number[], step_s: number): string[] {
  const day = new Intl.DateTimeFormat(dateLocale(), { day: 'numeric', month: 'short' });
  const time = new Intl.DateTimeFormat(dateLocale(), { hour: '2-digit', minute: '2-digit' });
  const days = ticks.map((t_s) => day.format(1000 * t_s));
  if (step_s >= DAY_S) return days;
  return ticks.map((t_s, k) => time.format(1000 * t_s) + (days[k] === days[k - 1] ? '' : `\n${days[k]}`));
}

/** As many decimals as tell ticks this far apart from each other. */
function decimalsOf(step: number): number {
  const enough = DECIMALS.find((places) => Math.abs(step - Number(step.toFixed(places))) < 1e-3 * step);
  return enough ?? DECIMALS.length;
}

/** A colour of the present theme, as a canvas wants it. */
function coloured(place: HTMLElement, name: string): string {
  place.style.color = `var(${name})`;
  return getComputedStyle(place).color;
}
