import { nameFile } from '../ui/file-name';
import { type Line, Plot } from '../ui/plot';
import { INTERVAL, scaleOf } from '../ui/units';
import { words } from '../words';
import { run } from './run';
import { massTrace, wrenchTrace } from './traces';

const COLOURS = ['--series-x', '--series-y', '--series-z'] as const;

/** Force or torque of the last seconds: measured, and as the estimate so far says it should be. */
export function WrenchPlot({ part }: { part: 'force' | 'torque' }) {
  const said = words.value.running;
  const { factor, unit } = scaleOf(part);
  const rows = wrenchTrace.value;
  const first = part === 'force' ? 0 : 3;
  const axes = COLOURS.map((colour, k) => ({ colour, label: `${'xyz'[k]}` }));
  const lines: Line[] = [
    ...axes,
    ...axes.map(({ colour, label }) => ({
      colour,
      label: `_${label}`,
      name: `${label} ${said.reconstructed}`,
      dashed: true,
    })),
  ];
  const scaled = (value: number | null | undefined) => (value == null ? null : factor * value);
  const data = [
    rows.map((row) => row.t_s),
    ...axes.map((_, k) => rows.map((row) => scaled(row.measured[first + k]))),
    ...axes.map((_, k) => rows.map((row) => scaled(row.reconstructed[first + k]))),
  ];
  return (
    <Plot
      title={`${said[part]}, ${unit}`}
      note={`— ${said.measured} – – ${said.reconstructed}`}
      lines={lines}
      data={data as [number[], ...(number | null)[][]]}
      unit={unit}
      file={nameOfFile(part)}
      together="wrench"
      live
    />
  );
}

/** The mass as it closes in, with its 95 % interval. */
export function MassPlot() {
  const said = words.value.running;
  const { factor, unit } = scaleOf('mass');
  const rows = massTrace.value;
  const at = (times: number) => rows.map((row) => factor * (row.mass_kg + times * row.std_kg));
  const lines: Line[] = [
    { label: '_mass', name: said.mass, colour: '--ink' },
    { label: '_high', name: words.value.charts.upper, colour: '--band' },
    { label: '_low', name: words.value.charts.lower, colour: '--band' },
  ];
  const data = [rows.map((row) => row.t_s), at(0), at(INTERVAL), at(-INTERVAL)];
  return (
    <Plot
      title={`${said.mass}, ${unit}`}
      note={words.value.interval}
      lines={lines}
      data={data as [number[], ...number[][]]}
      bands={[[2, 3]]}
      unit={unit}
      file={nameOfFile('mass')}
      live
    />
  );
}

/** By run, tool and day. */
function nameOfFile(what: string): string {
  const shown = run.value;
  return nameFile(['run', shown?.run, shown?.payload, what], shown?.requested_at ?? new Date().toISOString());
}
