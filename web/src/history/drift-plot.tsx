import type { RunAnswer } from '../api';
import { type Line, Plot } from '../ui/plot';
import { INTERVAL, scaleOf } from '../ui/units';
import { words } from '../words';
import { type Followed, PARAMETERS } from './followed-parameters';

const LINES: Line[] = [
  { label: '_low', colour: '--line', drawn: 'bars' },
  { label: '_high', colour: '--line', drawn: 'not' },
  { label: '_value', colour: '--ink', drawn: 'dots' },
];

/** A parameter from run to run, each with its 95 % interval. */
export function DriftPlot({ runs, followed }: { runs: RunAnswer[]; followed: Followed }) {
  const said = words.value.history;
  const { quantity } = PARAMETERS[followed];
  const { factor, unit } = scaleOf(quantity);
  const rows = runs.flatMap((run) => rowsOf(run, followed, factor)).reverse();
  if (rows.length === 0) return <p class="hint">{said.noneDetermined}</p>;
  const data = [0, 1, 2, 3].map((k) => rows.map((row) => row[k] ?? null));
  const title = `${said.parameters[followed]}, ${unit}`;
  return (
    <Plot
      title={title}
      note={words.value.interval}
      lines={LINES}
      data={data as [number[], ...(number | null)[][]]}
      since="1970"
    />
  );
}

type Row = [number, number | null, number | null, number];

/** Time, the ends of the interval, the value. */
function rowsOf({ result, ended_at }: RunAnswer, followed: Followed, factor: number): Row[] {
  if (result === null || ended_at === null) return [];
  const [value, std] = PARAMETERS[followed].of(result);
  if (value == null) return [];
  const end = (times: number) => (std == null ? null : factor * (value + times * std));
  return [[Date.parse(ended_at) / 1000, end(-INTERVAL), end(INTERVAL), factor * value]];
}
