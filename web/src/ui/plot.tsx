import 'uplot/dist/uPlot.min.css';
import { type Signal, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import UPlot from 'uplot';
import { dark, language } from '../session/settings';
import { type Line, legendOf } from './plot-line';
import { optionsOf, type Since } from './plot-options';
import { PlotReadout } from './plot-readout';
import { PlotTools } from './plot-tools';
import { extentOf, followGestures, isZoomed } from './plot-zoom';

export type { Line };

interface Props {
  title: string;
  note: string;
  lines: Line[];
  /** Time (s), then one row per line. */
  data: UPlot.AlignedData;
  /** Of the values. */
  unit: string;
  /** What a file of it is called, without its ending. */
  file: string;
  /** What the times count from: the beginning of a run, or 1970. */
  since?: Since;
  /** Pairs of lines with the space between them shaded. */
  bands?: [number, number][];
  /** Plots of one name have one crosshair. */
  together?: string;
  /** New samples arrive all the time: what is looked at closely stands still until all of it is shown again. */
  live?: boolean;
}

/** Lines over time, drawn again when the data change; to be looked at closely, read off and saved. */
export function Plot(props: Props) {
  const { title, note, lines, unit, since = 'run' } = props;
  const frame = useRef<HTMLDivElement>(null);
  const plot = useRef<UPlot | null>(null);
  const hidden = useSignal<readonly string[]>([]);
  const zoomed = useSignal(false);
  const row = useSignal<number | null>(null);
  useDrawing(props, frame, plot, { hidden, zoomed, row });
  return (
    <figure class="plot">
      <figcaption>
        <b>{title}</b> <small>{note}</small>
        {legendOf(lines).map((line) => (
          <span
            key={line.label}
            class={line.dashed ? 'key dashed' : 'key'}
            hidden={hidden.value.includes(line.label)}
            style={{ color: `var(${line.colour})` }}
          >
            <span>{line.label}</span>
          </span>
        ))}
      </figcaption>
      <div class="plane">
        <div class="canvas" ref={frame} role="img" aria-label={title} />
        <PlotReadout
          plot={plot}
          row={row.value}
          lines={lines}
          hidden={hidden.value}
          unit={unit}
          since={since}
        />
      </div>
      <PlotTools {...props} since={since} plot={plot} hidden={hidden} zoomed={zoomed} />
    </figure>
  );
}

interface Looking {
  hidden: Signal<readonly string[]>;
  zoomed: Signal<boolean>;
  row: Signal<number | null>;
}

/** Keeps a drawing in its place: made anew when its lines, colours or words are others, drawn again when its data are. */
function useDrawing(
  { lines, data, bands = [], since = 'run', together, live = false }: Props,
  frame: { current: HTMLDivElement | null },
  plot: { current: UPlot | null },
  { hidden, zoomed, row }: Looking,
): void {
  const look = [...lines.map((line) => line.label + line.colour), dark.value, language.value].join();
  // biome-ignore lint/correctness/useExhaustiveDependencies: the data and what is hidden follow below
  useEffect(() => {
    const place = frame.current;
    if (place === null) return undefined;
    const size = () => ({ width: place.clientWidth, height: place.clientHeight });
    const told = {
      point: (at: number | null) => {
        row.value = at;
      },
      scale: (of: UPlot) => {
        zoomed.value = isZoomed(of);
      },
    };
    const made = new UPlot(
      { ...size(), ...optionsOf(place, lines, bands, since, together, told) },
      data,
      place,
    );
    plot.current = made;
    followGestures(made);
    const watcher = new ResizeObserver(() => made.setSize(size()));
    watcher.observe(place);
    return () => {
      watcher.disconnect();
      made.destroy();
    };
  }, [look]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: drawn when the data change, or the whole is shown again
  useEffect(() => {
    const drawn = plot.current;
    if (drawn === null || (live && zoomed.value)) return;
    const same = extentOf(drawn.data).join() === extentOf(data).join();
    const { min, max } = drawn.scales.x ?? {};
    drawn.setData(data, !(same && zoomed.value));
    if (same && zoomed.value && min != null && max != null) drawn.setScale('x', { min, max });
  }, [data, live && zoomed.value]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a new drawing shows everything
  useEffect(() => {
    lines.forEach(({ label }, k) => {
      const show = !hidden.value.includes(label.replace(/^_/, ''));
      if (plot.current?.series[k + 1]?.show !== show) plot.current?.setSeries(k + 1, { show });
    });
  }, [look, hidden.value]);
}
