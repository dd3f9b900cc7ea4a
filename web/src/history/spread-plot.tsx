import type { Scatter } from '../api';
import { INTERVAL, number, scaleOf } from '../ui/units';
import { headingOf, quantityOf, spelledTogether } from './series-rows';
import { seriesWords } from './series-words';

const WIDTH = 320;
const HEIGHT = 150;
const LEFT = 12;
const RIGHT = 12;
const TOP = 10;
const BOTTOM = 26;
/** More numbers below the runs would run into each other. */
const MOST_NUMBERS = 12;

interface Props {
  row: Scatter;
  /** The run that differs, by its place; -1 where none does. */
  apart: number;
}

/** One parameter in every run, each with its interval, on the interval of what they say together. */
export function SpreadPlot({ row, apart }: Props) {
  const said = seriesWords.value;
  const name = headingOf(row.name);
  const together = spelledTogether(row);
  return (
    <figure class="spread">
      <figcaption>
        <b>{name}</b>
        <span>{together === null ? said.notInAny : `${said.together} ${together}`}</span>
      </figcaption>
      {row.mean !== null && together !== null && (
        <Drawing row={row} mean={row.mean} apart={apart} label={said.drawnAs(name, together)} />
      )}
    </figure>
  );
}

function Drawing({ row, mean, apart, label }: Props & { mean: number; label: string }) {
  const half = row.half_width ?? 0;
  const ends = row.values.flatMap((value, k) => {
    const reach = INTERVAL * (row.stds[k] ?? 0);
    return value === null ? [] : [value - reach, value + reach];
  });
  const [low, high] = [Math.min(mean - half, ...ends), Math.max(mean + half, ...ends)];
  const span = high > low ? high - low : 1;
  const y = (value: number) => TOP + ((HEIGHT - TOP - BOTTOM) * (high - value)) / span;
  const count = row.values.length;
  const x = (k: number) => LEFT + ((WIDTH - LEFT - RIGHT) * (k + 0.5)) / count;
  const step = Math.ceil(count / MOST_NUMBERS);
  const { factor, unit } = scaleOf(quantityOf(row));
  return (
    <div class="spread-plane">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label}>
        <rect
          class="band"
          x={LEFT}
          width={WIDTH - LEFT - RIGHT}
          y={y(mean + half)}
          height={y(mean - half) - y(mean + half)}
        />
        <line class="mean" x1={LEFT} x2={WIDTH - RIGHT} y1={y(mean)} y2={y(mean)} />
        {row.values.map((value, k) => {
          if (value === null) return null;
          const reach = INTERVAL * (row.stds[k] ?? 0);
          return (
            <g key={k} class={k === apart ? 'run apart' : 'run'}>
              <line x1={x(k)} x2={x(k)} y1={y(value + reach)} y2={y(value - reach)} />
              {k === apart ? (
                <path d={`M${x(k)} ${y(value) - 9}l9 9l-9 9l-9 -9z`} />
              ) : (
                <circle cx={x(k)} cy={y(value)} r={5} />
              )}
            </g>
          );
        })}
        {row.values.map((_, k) =>
          k % step === 0 || k === apart ? (
            <text key={k} class={k === apart ? 'apart' : ''} x={x(k)} y={HEIGHT - 6}>
              {k + 1}
            </text>
          ) : null,
        )}
      </svg>
      <small class="spread-height">
        ↕ {number(factor * span, places(factor * span))} {unit}
      </small>
    </div>
  );
}

/** Decimals that show two digits. */
function places(size: number): number {
  return size > 0 ? 1 - Math.floor(Math.log10(size)) : 0;
}
