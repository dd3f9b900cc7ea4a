import type { DiagnosisPublic } from '../api';
import { Facts } from '../ui/facts';
import { number } from '../ui/units';
import { words } from '../words';
import { CHANNELS } from './channel-choice';
import { candidatesOf, phaseName, times } from './effect-values';

type Diagnosis = NonNullable<DiagnosisPublic['result']>;
type Gap = NonNullable<Diagnosis['gap']>;

/** How far the gap closes on motions that the fit did not see, in all and by channel. */
export function HowFar({ diagnosis }: { diagnosis: Diagnosis }) {
  const said = words.value.gap;
  const { gap } = diagnosis;
  if (gap === null) return null;
  return (
    <section class="how-far">
      <h2>{said.howFar}</h2>
      <Facts
        facts={[
          {
            name: said.gap,
            value: `${number(gap.before, 2)} → ${number(gap.after, 2)}`,
            note: said.floor,
          },
          ...closureOf(diagnosis),
        ]}
      />
      <ChannelBars gap={gap} />
      <p class="hint">{said.unseen(gap.held_out.map(phaseName).join(', '))}</p>
    </section>
  );
}

/** The share of the gap that the most probable effect closes, with its interval where there is one. */
function closureOf(diagnosis: Diagnosis) {
  const [best] = candidatesOf(diagnosis);
  if (best === undefined || diagnosis.verdict === 'no_gap') return [];
  const within =
    best.interval === null ? '' : best.interval.map((share) => number(100 * share, 1)).join(' … ');
  const value = `${number(100 * best.closure, 1)} %`;
  return [{ name: words.value.gap.closure, value, note: within && `95 %: ${within} %` }];
}

/** Before and after of each channel as bars from nothing, with a line where noise alone ends. */
function ChannelBars({ gap }: { gap: Gap }) {
  const said = words.value.gap;
  const rows = CHANNELS.flatMap((channel) => {
    const change = gap.by_channel[channel];
    return change === undefined ? [] : [{ channel, ...change }];
  });
  const most = Math.max(1, ...rows.flatMap(({ before, after }) => [before, after]));
  const width = (value: number) => ({ width: `${(100 * value) / most}%` });
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys
    <div class="scrolls" tabIndex={0}>
      <table class="channel-bars">
        <caption>{said.channels}</caption>
        <thead>
          <tr>
            <th scope="col">{said.channel}</th>
            <th scope="col">
              <i class="was" aria-hidden="true" /> {said.before}
            </th>
            <th scope="col">
              <i class="is" aria-hidden="true" /> {said.after}
            </th>
            <th scope="col">
              <i class="floor" aria-hidden="true" /> {said.floor}
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map(({ channel, before, after }) => (
            <tr key={channel}>
              <th scope="row">{channel}</th>
              <td>{times(before)}</td>
              <td>{times(after)}</td>
              <td class="two-bars" aria-hidden="true">
                <i class="was" style={width(before)} />
                <i class="is" style={width(after)} />
                <i class="floor" style={{ left: `${100 / most}%` }} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
