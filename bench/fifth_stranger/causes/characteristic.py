"""The sensor reads a load wrongly, at once: bridges, leaks, bolts, a stop that begins to carry, a weak supply."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")


def gain_bridge(rng: np.random.Generator, _: Rig) -> Fault:
    """A resistor of one bridge was replaced: two channels that share it read too much, one of them more than the other."""
    first = int(rng.integers(2))
    e = np.zeros(6)
    e[[first, 4 - first]] = np.array([0.03, 0.021]) * rng.choice([-1, 1])
    return Fault(
        size=lambda scale: Size(f"gain error {CHANNELS[first]} ({CHANNELS[4 - first]} 0.7 of it)", 100 * scale * e[first], "%"),
        distort=lambda W, scale: W * (1 + scale * e),
    )


def gain_aged(rng: np.random.Generator, rig: Rig) -> Fault:
    """Gauges that aged unevenly since the sensor was last calibrated; as they warm the error shrinks by a tenth."""
    e = 0.02 * rng.uniform(0.4, 1, 6) * np.array([1, -1, 1, -1, -1, 1]) * rng.choice([-1, 1])
    warm = 1 - 0.1 * rig.t / rig.seconds
    return Fault(
        size=lambda scale: Size("gain error fx (others of 0.4 to 2 times that, of either sign)", 100 * scale * e[0], "%"),
        distort=lambda W, scale: W * (1 + scale * np.outer(warm, e)),
    )


def _cross(C: Array, what: str, share: float) -> Fault:
    return Fault(size=lambda scale: Size(what, 100 * scale * share, "%"), distort=lambda W, scale: W + scale * W @ C.T)


def cross_leak(rng: np.random.Generator, rig: Rig) -> Fault:
    """Moisture in the plug: each wire leaks into its neighbour, most between the first two."""
    C, share = np.zeros((6, 6)), np.array([0.025, 0.012, 0.006, 0.015, 0.01]) * rng.choice([-1, 1])
    C[np.arange(1, 6), np.arange(5)] = share * rig.noise_std[1:] / rig.noise_std[:-1]
    return _cross(C, "fx shows in fy, by noise for noise", share[0])


def cross_bolts(rng: np.random.Generator, rig: Rig) -> Fault:
    """Bolts that were tightened unevenly: pull along the axis bends, and bending pulls."""
    C, share = np.zeros((6, 6)), rng.choice([-1, 1]) * np.array([0.03, -0.018, 0.012, 0.02])
    C[3, 2], C[4, 2], C[2, 3], C[2, 4] = share
    return _cross(C * np.outer(rig.noise_std, 1 / rig.noise_std), "fz shows in tx, by noise for noise", share[0])


def nonlin_stop(_: np.random.Generator, rig: Rig) -> Fault:
    """The stop that protects the beams has chips under it and begins to carry too soon, softly, above half of the most that there is."""
    most = np.max(np.abs(rig.load), axis=0)
    share = np.array([1, 0.8, 1, 0.6, 0.9, 0.3])

    def carry(W: Array, scale: float) -> Array:
        beyond = 0.06 * np.logaddexp(0, (np.abs(W) / most - 0.55) / 0.06)
        return np.asarray(W - 0.08 * scale * share * np.sign(W) * most * beyond)

    return Fault(size=lambda scale: Size("the stop carries, of what is above half of the peak", 8 * scale, "%"), distort=carry)


def nonlin_tension(rng: np.random.Generator, rig: Rig) -> Fault:
    """Beams that buckle a little in push: what is read grows faster than the load in pull, and slower by half of that in push."""
    most = np.max(np.abs(rig.load), axis=0)
    e = 0.03 * rng.uniform(0.5, 1, 6) * rng.choice([-1, 1])
    return Fault(
        size=lambda scale: Size("reads too much at its peak in pull, fx", 100 * scale * e[0], "%"),
        distort=lambda W, scale: W + scale * e * W**2 / most * np.where(W > 0, 1, -0.5),
    )


def sat_supply(_: np.random.Generator, rig: Rig) -> Fault:
    """The supply is weak: two channels bend off before their peak and go no further."""
    moves = np.ptp(rig.load, axis=0) / rig.noise_std
    worst = np.argsort(moves)[-2:]
    middle, half = (np.max(rig.load, axis=0) + np.min(rig.load, axis=0)) / 2, np.ptp(rig.load, axis=0) / 2

    def clip(W: Array, scale: float) -> Array:
        read, level = W.copy(), 1 / (1 + 0.2 * scale)
        for i in worst:
            x = (W[:, i] - middle[i]) / half[i] / level
            read[:, i] = middle[i] + half[i] * level * x / (1 + np.abs(x) ** 12) ** (1 / 12)
        return read

    names = " and ".join(CHANNELS[i] for i in sorted(worst.tolist()))
    return Fault(size=lambda scale: Size(f"{names} end softly, at share of their peak", 1 / (1 + 0.2 * scale), "-"), distort=clip)
