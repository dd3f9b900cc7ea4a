import 'uplot/dist/uPlot.min.css';
import { useEffect, useRef } from 'preact/hooks';
import UPlot from 'uplot';
import { dark, language } from '../session/settings';
import { DATES, number } from './units';

export interface Line {
  label: string;
  /** Name of a colour in look/tokens.css. */
  colour: string;
  dashed?: boolean;
  /** What is drawn in place of a line through the values: a dot at each, bars from them to the next line's values, or nothing. */
  drawn?: 'dots' | 'bars' | 'not';
}

type Since = 'run' | '1970';

interface Props {
  title: string;
  note: string;
  lines: Line[];
  /** Time (s), then one row per line. */
  data: UPlot.AlignedData;
  /** What the times count from: the beginning of a run, or 1970. */
  since?: Since;
  /** Pairs of lines with the space between them shaded. */
  bands?: [number, number][];
}

const AXIS_PX = 56;
const TICK_PX = 32;
/** However low a plot is, there are about so many. */
const FEWEST_TICKS = 2;
const DIGIT_PX = 9;
const DECIMALS = [0, 1, 2, 3, 4, 5, 6];
const SECONDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60];
const DAY_S = 86_400;
const LEAST_S = 3600;
const FONT = '14px system-ui, sans-serif';

/** Lines over time, drawn again when the data change. */
export function Plot({ title, note, lines, data, bands = [], since = 'run' }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const plot = useRef<UPlot | null>(null);
  const look = [...lines.map((line) => line.label + line.colour), dark.value, language.value].join();
  // biome-ignore lint/correctness/useExhaustiveDependencies: made anew only when its lines, colours or words are others; the data follow below
  useEffect(() => {
    const place = frame.current;
    if (place === null) return undefined;
    const size = () => ({ width: place.clientWidth, height: place.clientHeight });
    const made = new UPlot({ ...size(), ...optionsOf(place, lines, bands, since) }, data, place);
    plot.current = made;
    const watcher = new ResizeObserver(() => made.setSize(size()));
    watcher.observe(place);
    return () => {
      watcher.disconnect();
      made.destroy();
    };
  }, [look]);
  useEffect(() => plot.current?.setData(data), [data]);
  return (
    <figure class="plot">
      <figcaption>
        <b>{title}</b> <small>{note}</small>
        {lines
          .filter((line) => !line.label.startsWith('_'))
          .map((line) => (
            <span
              key={line.label}
              class={line.dashed ? 'key dashed' : 'key'}
              style={{ color: `var(${line.colour})` }}
            >
              <span>{line.label}</span>
            </span>
          ))}
      </figcaption>
      <div class="canvas" ref={frame} role="img" aria-label={title} />
    </figure>
  );
}

function optionsOf(
  place: HTMLElement,
  lines: Line[],
  bands: [number, number][],
  since: Since,
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
    cursor: { show: false },
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
    hooks: { draw: [({ data: [times] }) => note(place, times.at(-1))] },
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

/** From a little before the first moment to a little after the last, and an hour at least. */
function roomy(_plot: UPlot, first_s: number, last_s: number): [number, number] {
  const room_s = Math.max(0.05 * (last_s - first_s), (LEAST_S - (last_s - first_s)) / 2);
  return [first_s - room_s, last_s + room_s];
}

function datesOf(ticks: number[], step_s: number): string[] {
  const day = new Intl.DateTimeFormat(DATES[language.value], { day: 'numeric', month: 'short' });
  const time = new Intl.DateTimeFormat(DATES[language.value], { hour: '2-digit', minute: '2-digit' });
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
