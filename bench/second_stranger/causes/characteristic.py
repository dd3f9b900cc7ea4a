"""The sensor reads a load wrongly, at once: gain, crosstalk, bent lines, a rail."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig

FULL_SCALE = np.array([80, 80, 120, 4, 4, 4.0])
"""(6,), N and N m."""


def gain_warm(rng: np.random.Generator, rig: Rig) -> Fault:
    """It grows."""
    e = np.array([1, 0.7, -0.2, 0.5, 0.9, 0.1]) * rng.choice([-1, 1])
    shape = 0.45 + 0.55 * (1 - np.exp(-rig.t / (rig.seconds * 0.3)))
    return Fault(
        size=lambda scale: Size("gain error (grows from 45 % to 100 % as bridge warms), fx", 3 * scale * e[0], "%"),
        distort=lambda W, scale: W * (1 + 0.03 * scale * np.outer(shape, e)),
    )


def gain_fixed(_: np.random.Generator, __: Rig) -> Fault:
    """Of three channels."""
    e = np.array([0, 0.04, -0.012, 0.0, 0.0, 0.025])
    return Fault(
        size=lambda scale: Size("gain error fy (fz, tz less)", 4 * scale, "%"),
        distort=lambda W, scale: W * (1 + scale * e),
    )


def cross_plate(_: np.random.Generator, __: Rig) -> Fault:
    """Mostly of fz into the others."""
    C = np.zeros((6, 6))
    C[0, 2], C[1, 2], C[3, 2], C[4, 2], C[2, 4], C[5, 1] = 0.025, -0.015, 0.0011, 0.0006, 0.12, 0.0008
    return Fault(
        size=lambda scale: Size("fz shows in fx", 2.5 * scale, "%"),
        distort=lambda W, scale: W + scale * W @ C.T,
    )


def cross_oneside(_: np.random.Generator, __: Rig) -> Fault:
    """Of fz into the others, where it presses."""
    C = np.zeros((6, 6))
    C[0, 2], C[1, 2], C[3, 2], C[4, 2] = 0.03, 0.02, 0.0012, -0.001
    knee = 2.0

    def leak(W: Array, scale: float) -> Array:
        pressed = np.zeros_like(W)
        pressed[:, 2] = knee * np.logaddexp(0, W[:, 2] / knee)
        return np.asarray(W + scale * (pressed @ C.T))

    return Fault(
        size=lambda scale: Size("fz in compression only (warped plate) shows in fx", 3 * scale, "%"),
        distort=leak,
    )


def nonlin_cubic(_: np.random.Generator, __: Rig) -> Fault:
    """The same for both signs of a load."""
    return Fault(
        size=lambda scale: Size("hardening, cubic, at full scale (80/80/120 N, 4 N m)", 8 * scale, "% FS"),
        distort=lambda W, scale: W + 0.08 * scale * W * (W / FULL_SCALE) ** 2,
    )


def nonlin_even(_: np.random.Generator, __: Rig) -> Fault:
    """Another for each sign of a load."""
    e = np.array([1, -0.6, 0.8, 0.5, 0.9, -0.3]) * 0.03
    return Fault(
        size=lambda scale: Size("even-order (tension against compression) at full scale", 3 * scale, "% FS"),
        distort=lambda W, scale: W + scale * e * W * W / FULL_SCALE,
    )


def sat_soft(rng: np.random.Generator, rig: Rig) -> Fault:
    """The amplifier's upper rail, on load and offset of two channels, with a knee that is not sharp."""
    load = rig.load + rig.offset
    channels = [int(rng.integers(2)), 2]
    highest = {i: np.quantile(load[:, i], 0.97) for i in channels}

    def clip(W: Array, scale: float) -> Array:
        Y = W + rig.offset
        for i in channels:
            span = np.ptp(W[:, i])
            rail, width = highest[i] - 0.10 * scale * span, 0.012 * span
            Y[:, i] = rail - width * np.logaddexp(0, (rail - Y[:, i]) / width)
        return Y - rig.offset

    what = f"upper rail below the peak by share of the span (channels {[('fx', 'fy', 'fz')[i] for i in channels]})"
    return Fault(size=lambda scale: Size(what, 0.10 * scale, "-"), distort=clip)
