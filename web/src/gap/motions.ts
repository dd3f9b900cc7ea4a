import type { ChannelOverlay, OverlayPublic } from '../api';

/** One stretch of the same motion. */
export interface Motion {
  phase: string;
  /** Rows of the overlay: first, and the one after the last. */
  from: number;
  to: number;
}

/** The motions of an overlay, in their order. */
export function motionsOf({ phase }: OverlayPublic): Motion[] {
  const found: Motion[] = [];
  phase.forEach((name, k) => {
    const last = found.at(-1);
    if (last?.phase === name) last.to = k + 1;
    else found.push({ phase: name, from: k, to: k + 1 });
  });
  return found;
}

/** Motion and channel in which measured and simulated lay furthest apart before, against the noise. */
export function worstOf(overlay: OverlayPublic, motions: Motion[]): { motion: number; channel: string } {
  const all = motions.flatMap((each, motion) =>
    overlay.channels.map((channel) => ({ motion, channel: channel.channel, gap: gapOf(channel, each) })),
  );
  const [worst] = all.sort((one, other) => other.gap - one.gap);
  return worst ?? { motion: 0, channel: '' };
}

function gapOf({ measured, before, std }: ChannelOverlay, { from, to }: Motion): number {
  return measured.slice(from, to).reduce((sum, value, k) => {
    const gap = (value - (before[from + k] ?? value)) / std;
    return sum + gap ** 2;
  }, 0);
}
