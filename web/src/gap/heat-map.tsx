import { useSignal } from '@preact/signals';
import type { DiagnosisPublic } from '../api';
import { Choice } from '../ui/choice';
import { number, percent } from '../ui/units';
import { words } from '../words';
import { CHANNELS } from './channel-choice';
import { phaseName, times } from './effect-values';

type Cell = NonNullable<NonNullable<DiagnosisPublic['result']>['where']>['cells'][number];

const ALL = 'all';
const KINDS = ['hold', 'rotate', 'transfer'];
/** Where the tints begin, in multiples of the noise. */
const TINTS = [2, 5, 15, 40, 100];

/** Width of a column with its number. */
const LEAST_PX = 48;

/** How dark a multiple of the noise is drawn, 0 to 5; the number stands beside it. */
export function tintOf(value: number): number {
  return TINTS.filter((limit) => value >= limit).length;
}

/** Where the gap lies: channel by motion, of one frequency band or the loudest of all. */
export function HeatMap({ cells }: { cells: Cell[] }) {
  const said = words.value.gap;
  const band = useSignal(ALL);
  const bands = [...new Map(cells.map((cell) => [bandOf(cell), cell.band_hz])).entries()].sort(
    ([, [one]], [, [other]]) => one - other,
  );
  const shown = cells.filter((cell) => band.value === ALL || bandOf(cell) === band.value);
  const phases = [...new Set(cells.map((cell) => cell.phase))].sort((a, b) => (rank(a) < rank(b) ? -1 : 1));
  const [most] = shown.toSorted((one, other) => other.share - one.share);
  return (
    <div class="heat-map">
      {bands.length > 1 && (
        <Choice
          legend={said.band}
          inRow
          options={[
            { value: ALL, label: said.allBands },
            ...bands.map(([value, range]) => ({ value, label: bandName(range) })),
          ]}
          chosen={band.value}
          choose={(value) => {
            band.value = value;
          }}
        />
      )}
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys */}
      <div class="scrolls" tabIndex={0}>
        <table class="heat" style={{ minWidth: `${LEAST_PX * (phases.length + 2)}px` }}>
          <caption>{said.heat}</caption>
          <thead>
            <tr>
              <th scope="col">
                <span class="out-of-sight">{said.channel}</span>
              </th>
              {phases.map((phase) => (
                <th scope="col" key={phase}>
                  {phaseName(phase)}
                </th>
              ))}
              <th scope="col">{said.share}</th>
            </tr>
          </thead>
          <tbody>
            {CHANNELS.map((channel) => (
              <Row
                key={channel}
                channel={channel}
                phases={phases}
                cells={shown.filter((cell) => cell.channel === channel)}
                most={most}
              />
            ))}
          </tbody>
        </table>
      </div>
      <p class="hint">{said.heatNote}</p>
    </div>
  );
}

interface RowProps {
  channel: string;
  phases: string[];
  cells: Cell[];
  /** Where the largest share of the gap lies. */
  most: Cell | undefined;
}

function Row({ channel, phases, cells, most }: RowProps) {
  return (
    <tr>
      <th scope="row">{channel}</th>
      {phases.map((phase) => {
        const here = cells.filter((cell) => cell.phase === phase);
        if (here.length === 0) return <td key={phase}>–</td>;
        const value = Math.max(...here.map((cell) => cell.times_noise));
        const loudest = most !== undefined && here.includes(most);
        return (
          <td key={phase} class={`tint tint-${tintOf(value)}${loudest ? ' most' : ''}`}>
            {times(value)}
          </td>
        );
      })}
      <td>{percent(cells.reduce((sum, cell) => sum + cell.share, 0))}</td>
    </tr>
  );
}

/** A band in words. */
export function bandName([low, high]: readonly [number, number]): string {
  return words.value.gap.hertz(number(low, 0), number(high, 0));
}

function bandOf(cell: Cell): string {
  return cell.band_hz.join('-');
}

/** Holds first, then turns, then transfers, then whatever else there is. */
function rank(phase: string): string {
  const kind = KINDS.indexOf(phase.split(':')[0] ?? '');
  return `${kind < 0 ? KINDS.length : kind}${phase}`;
}
