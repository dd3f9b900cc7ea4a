import { useComputed, useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { ChannelOverlay, OverlayPublic } from '../api';
import { nameFile } from '../ui/file-name';
import { type Line, Plot } from '../ui/plot';
import { Press } from '../ui/press';
import { clock, scaleOf } from '../ui/units';
import { words } from '../words';
import { ChannelChoice } from './channel-choice';
import { phaseName } from './effect-values';
import { type Motion, motionsOf, worstOf } from './motions';

const WHOLE = -1;

interface Props {
  overlay: OverlayPublic;
  /** What a file of a plot is called, without what it shows; `when`: the day that it is of. */
  file: readonly (string | null)[];
  when: string;
}

/** Measured and simulated, before and after, of some channels: motion by motion, beginning with the worst. */
export function OverlayPlots({ overlay, file, when }: Props) {
  const said = words.value.gap;
  const motions = useMemo(() => motionsOf(overlay), [overlay]);
  const worst = useMemo(() => worstOf(overlay, motions), [overlay, motions]);
  const chosen = useSignal<readonly string[]>([worst.channel]);
  const motion = useSignal(worst.motion);
  const shown = useComputed(() => overlay.channels.filter((each) => chosen.value.includes(each.channel)));
  const whole: Motion = { phase: said.whole, from: 0, to: overlay.t_s.length };
  const part = motions[motion.value] ?? whole;
  const choose = (next: number) => () => {
    motion.value = next;
  };
  return (
    <section class="overlay">
      <h2>{said.overlay}</h2>
      <ChannelChoice chosen={chosen} />
      <div class="motion-choice">
        <Press act={choose(Math.max(0, motion.value - 1))} disabled={motion.value <= 0}>
          <span aria-hidden="true">◀</span>
          <span class="out-of-sight">{said.previous}</span>
        </Press>
        <b role="status">
          {phaseName(part.phase)}
          <small>
            {clock(overlay.t_s[part.from] ?? 0)} – {clock(overlay.t_s[part.to - 1] ?? 0)}
          </small>
        </b>
        <Press act={choose(motion.value + 1)} disabled={motion.value >= motions.length - 1}>
          <span aria-hidden="true">▶</span>
          <span class="out-of-sight">{said.following}</span>
        </Press>
        <Press act={choose(WHOLE)} disabled={motion.value === WHOLE}>
          {said.whole}
        </Press>
      </div>
      {shown.value.map((each) => (
        <Pair
          key={each.channel}
          t_s={overlay.t_s}
          channel={each}
          part={part}
          file={(what) => nameFile([...file, part.phase, what], when)}
        />
      ))}
      <p class="hint">{said.overlayNote}</p>
    </section>
  );
}

interface PairProps {
  t_s: number[];
  channel: ChannelOverlay;
  part: Motion;
  /** The name of a file of what is shown. */
  file: (what: string) => string;
}

/** The values, and below them what is left of them. */
function Pair({ t_s, channel: of, part: { from, to }, file }: PairProps) {
  const { channel, measured, before, after, std } = of;
  const said = words.value.gap;
  const { factor, unit } = scaleOf(channel.startsWith('f') ? 'force' : 'torque');
  const at = t_s.slice(from, to);
  const values = (all: number[]) => all.slice(from, to).map((value) => factor * value);
  const left = (all: number[]) =>
    all.slice(from, to).map((value, k) => ((measured[from + k] ?? value) - value) / std);
  const was: Line = { label: said.before, colour: '--series-z', dashed: true };
  const is: Line = { label: said.after, colour: '--series-x' };
  return (
    <>
      <Plot
        title={`${channel}, ${unit}`}
        note=""
        lines={[{ label: said.measured, colour: '--ink-soft' }, was, is]}
        data={[at, values(measured), values(before), values(after)]}
        unit={unit}
        file={file(channel)}
        together="overlay"
      />
      <Plot
        title={`${channel}: ${said.difference}`}
        note=""
        lines={[was, is]}
        data={[at, left(before), left(after)]}
        unit={said.timesNoise}
        file={file(`${channel}_difference`)}
        together="overlay"
      />
    </>
  );
}
