"""The sensor reads a load wrongly, at once: turned spans, a helix in its beams, beams that stiffen, a rail that is hard to leave."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig

RECOVERY_S = 0.15


def gain_span(rng: np.random.Generator, rig: Rig) -> Fault:
    """Spans of the moments' amplifiers were turned, two the one way and one the other; they creep back by a seventh of it."""
    e = np.array([0, 0, 0.006, 0.04, -0.028, 0.02]) * rng.choice([-1, 1])
    back = 1 - 0.14 * (1 - np.exp(-2 * rig.t / rig.seconds))
    return Fault(
        size=lambda scale: Size("gain error tx (ty the other way, 0.7 of it, tz half of it), a seventh goes back", 100 * scale * e[3], "%"),
        distort=lambda W, scale: W * (1 + scale * np.outer(back, e)),
    )


def cross_helical(rng: np.random.Generator, rig: Rig) -> Fault:
    """Beams that were ground askew: a pull along the axis shows as a twist and as shear, and a twist as a pull."""
    C = np.zeros((6, 6))
    share = np.array([0.02, -0.013, 0.009, 0.03]) * rng.choice([-1, 1])
    C[5, 2], C[0, 2], C[1, 2], C[2, 5] = share
    C *= np.outer(rig.noise_std, 1 / rig.noise_std)
    return Fault(
        size=lambda scale: Size("fz shows in tz, by noise for noise", 100 * scale * share[0], "%"),
        distort=lambda W, scale: W + scale * W @ C.T,
    )


def nonlin_radial(_: np.random.Generator, rig: Rig) -> Fault:
    """The beams stiffen with the square of the whole lateral force: its components bend each other's characteristic."""
    most = np.max(np.sum(rig.load[:, :2] ** 2, 1))
    share = np.array([1, 1, 0.35, 0.8, 0.8, 0.5])

    def stiffen(W: Array, scale: float) -> Array:
        lateral = np.sum(W[:, :2] ** 2, 1) / most
        return np.asarray(W * (1 - 0.04 * scale * np.outer(lateral, share)))

    return Fault(size=lambda scale: Size("reads less by the square of the lateral force, at its peak", 4 * scale, "%"), distort=stiffen)


def sat_recovery(_: np.random.Generator, rig: Rig) -> Fault:
    """One channel's amplifier ends at its rail, and needs a while to leave it."""
    moves = np.ptp(rig.load, axis=0) / rig.noise_std
    channel = int(np.argmax(moves))
    x = rig.load[:, channel]
    toward = 1 if np.max(x) - np.median(x) > np.median(x) - np.min(x) else -1
    peak, span = np.max(toward * x), np.ptp(x)

    def clip(W: Array, scale: float) -> Array:
        level = peak - 0.15 * scale * span
        raw = toward * W[:, channel]
        last = np.maximum.accumulate(np.where(raw > level, np.arange(len(raw)), -(10**6)))
        since_s = 1e-3 * (np.arange(len(raw)) - last)
        stuck = np.clip(1 - since_s / RECOVERY_S, 0, 1)
        read = W.copy()
        read[:, channel] = toward * (stuck * level + (1 - stuck) * np.minimum(raw, level))
        return read

    name = ("fx", "fy", "fz", "tx", "ty", "tz")[channel]
    return Fault(
        size=lambda scale: Size(f"{name} at its rail, below its peak by share of its span, leaves it within 0.15 s", 0.15 * scale, "-"),
        distort=clip,
    )
