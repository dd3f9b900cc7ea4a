import { useComputed, useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { ChannelOverlay, OverlayAnswer } from '../api';
import { type Line, Plot } from '../ui/plot';
import { Press } from '../ui/press';
import { clock, scaleOf } from '../ui/units';
import { words } from '../words';
import { ChannelChoice } from './channel-choice';
import { phaseName } from './effect-values';
import { type Motion, motionsOf, worstOf } from './motions';

const WHOLE = -1;

/** Measured and simulated, before and after, of one channel: motion by motion, beginning with the worst. */
export function OverlayPlots({ overlay }: { overlay: OverlayAnswer }) {
  const said = words.value.gap;
  const motions = useMemo(() => motionsOf(overlay), [overlay]);
  const worst = useMemo(() => worstOf(overlay, motions), [overlay, motions]);
  const channel = useSignal(worst.channel);
  const motion = useSignal(worst.motion);
  const shown = useComputed(() => overlay.channels.find((each) => each.channel === channel.value));
  const whole: Motion = { phase: said.whole, from: 0, to: overlay.t_s.length };
  const part = motions[motion.value] ?? whole;
  const choose = (next: number) => () => {
    motion.value = next;
  };
  return (
    <section class="overlay">
      <h2>{said.overlay}</h2>
      <ChannelChoice chosen={channel} />
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
      {shown.value && <Pair t_s={overlay.t_s} channel={shown.value} part={part} />}
      <p class="hint">{said.overlayNote}</p>
    </section>
  );
}

interface PairProps {
  t_s: number[];
  channel: ChannelOverlay;
  part: Motion;
}

/** The values, and below them what is left of them. */
function Pair({ t_s, channel: { channel, measured, before, after, std }, part: { from, to } }: PairProps) {
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
      />
      <Plot title={said.difference} note="" lines={[was, is]} data={[at, left(before), left(after)]} />
    </>
  );
}
