import type { Signal } from '@preact/signals';
import type UPlot from 'uplot';
import { words } from '../words';
import { saveFile } from './file-name';
import { drawPng, writeCsv } from './plot-files';
import { type Line, legendOf } from './plot-line';
import type { Since } from './plot-options';
import { reset, zoom } from './plot-zoom';
import { Press } from './press';

interface Props {
  title: string;
  lines: Line[];
  unit: string;
  file: string;
  since: Since;
  plot: { current: UPlot | null };
  hidden: Signal<readonly string[]>;
  zoomed: Signal<boolean>;
}

const CLOSER = 0.5;

/** What can be done with a plot, folded into its corner; the way back from a part of it is always to be seen. */
export function PlotTools(props: Props) {
  const said = words.value.charts;
  const { title, lines, plot, hidden, zoomed } = props;
  const legend = legendOf(lines);
  const near = (factor: number) => () => {
    if (plot.current) zoom(plot.current, factor, plot.current.over.clientWidth / 2);
  };
  const whole = () => {
    if (plot.current) reset(plot.current);
  };
  return (
    <div class="plot-corner">
      {zoomed.value && (
        <Press act={whole}>
          <span aria-hidden="true">↺</span> {said.whole}
        </Press>
      )}
      <details class="plot-tools">
        <summary aria-label={said.tools(title)}>
          <span aria-hidden="true">⋯</span>
        </summary>
        <div>
          {legend.length > 1 && <Shown legend={legend} hidden={hidden} />}
          <Press act={near(CLOSER)}>{said.closer}</Press>
          <Press act={near(1 / CLOSER)} disabled={!zoomed.value}>
            {said.farther}
          </Press>
          <Downloads {...props} />
        </div>
      </details>
    </div>
  );
}

/** Which lines are drawn. */
function Shown({ legend, hidden }: { legend: Line[]; hidden: Signal<readonly string[]> }) {
  const flip = (label: string) => () => {
    const others = hidden.value.filter((each) => each !== label);
    hidden.value = others.length < hidden.value.length ? others : [...others, label];
  };
  return legend.map(({ label, colour, dashed }) => (
    <label class="option" key={label}>
      <input type="checkbox" checked={!hidden.value.includes(label)} onChange={flip(label)} />
      <span class={dashed ? 'key dashed' : 'key'} style={{ color: `var(${colour})` }}>
        <span>{label}</span>
      </span>
    </label>
  ));
}

function Downloads({ title, lines, unit, file, since, plot }: Props) {
  const csv = () => {
    if (plot.current) saveFile(`${file}.csv`, writeCsv(plot.current.data, lines, since, unit));
  };
  const png = async () => {
    if (plot.current) saveFile(`${file}.png`, await drawPng(plot.current, title, lines));
  };
  return (
    <>
      <Press act={csv}>CSV</Press>
      <Press act={png}>PNG</Press>
    </>
  );
}
