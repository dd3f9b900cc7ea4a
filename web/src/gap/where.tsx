import type { DiagnosisPublic } from '../api';
import { percent } from '../ui/units';
import { words } from '../words';
import { say } from '../words/messages';
import { phaseName, times } from './effect-values';
import { bandName, HeatMap, tintOf } from './heat-map';
import { JointTable } from './joint-table';
import { Strip } from './strip';

type Place = NonNullable<NonNullable<DiagnosisPublic['result']>['where']>;

/** A tenth of the time holds a tenth of the gap where it is the same throughout. */
const SHARES = [0.05, 0.1, 0.2, 0.4, 0.6];

/** Where the gap lies: a sentence, the heat map, and by time, direction, pose and joint. */
export function Where({ where }: { where: Place }) {
  const said = words.value.gap;
  return (
    <section class="where">
      <h2>{said.where}</h2>
      <p class="sentence">{sentenceOf(where)}</p>
      <HeatMap cells={where.cells} />
      {where.by_time.length > 0 && (
        <Strip
          title={said.byTime}
          cells={where.by_time.map((share) => ({
            name: '',
            value: percent(share),
            tint: SHARES.filter((limit) => share >= limit).length,
          }))}
        />
      )}
      <SquaresStrip title={said.byDirection} squares={where.by_direction} names={said.directions} />
      <SquaresStrip title={said.byPose} squares={where.by_pose ?? {}} names={{}} />
      <JointTable joints={where.joints ?? []} />
    </section>
  );
}

function sentenceOf({ cells, message }: Place): string {
  const [most] = cells;
  if (most === undefined) return say(message);
  const { channel, phase, band_hz, times_noise, share } = most;
  const said = words.value.gap;
  return said.whereSentence(channel, phaseName(phase), bandName(band_hz), times(times_noise), percent(share));
}

interface SquaresProps {
  title: string;
  /** Mean squares, noise being 1. */
  squares: Record<string, number>;
  names: Record<string, string>;
}

function SquaresStrip({ title, squares, names }: SquaresProps) {
  const cells = Object.entries(squares).map(([name, square]) => {
    const multiple = Math.sqrt(square);
    return { name: names[name] ?? name, value: times(multiple), tint: tintOf(multiple) };
  });
  return cells.length === 0 ? null : <Strip title={title} cells={cells} />;
}
