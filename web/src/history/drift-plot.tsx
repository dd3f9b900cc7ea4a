import type { RunPublic } from '../api';
import { nameFile } from '../ui/file-name';
import { type Line, Plot } from '../ui/plot';
import { INTERVAL, scaleOf } from '../ui/units';
import { words } from '../words';
import { type Followed, PARAMETERS } from './followed-parameters';

interface Props {
  runs: RunPublic[];
  followed: Followed;
  /** Whose runs they are, for the name of a file. */
  of: readonly string[];
}

/** A parameter from run to run, each with its 95 % interval. */
export function DriftPlot({ runs, followed, of }: Props) {
  const said = words.value.history;
  const { lower, upper } = words.value.charts;
  const lines: Line[] = [
    { label: '_low', name: lower, colour: '--line', drawn: 'bars' },
    { label: '_high', name: upper, colour: '--line', drawn: 'not' },
    { label: '_value', name: said.parameters[followed], colour: '--ink', drawn: 'dots' },
  ];
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
      lines={lines}
      data={data as [number[], ...(number | null)[][]]}
      since="1970"
      unit={unit}
      file={nameFile(['history', ...of, followed], new Date().toISOString())}
    />
  );
}

type Row = [number, number | null, number | null, number];

/** Time, the ends of the interval, the value. */
function rowsOf({ result, ended_at }: RunPublic, followed: Followed, factor: number): Row[] {
  if (result === null || ended_at === null) return [];
  const [value, std] = PARAMETERS[followed].of(result);
  if (value == null) return [];
  const end = (times: number) => (std == null ? null : factor * (value + times * std));
  return [[Date.parse(ended_at) / 1000, end(-INTERVAL), end(INTERVAL), factor * value]];
}
