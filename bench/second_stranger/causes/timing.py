"""Wrench and joints are not of the same moment: delays and lags."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import lag, lag_columns


def delay_skew(_: np.random.Generator, rig: Rig) -> Fault:
    """Two clocks run at two speeds."""
    first = 0.55
    return Fault(
        size=lambda scale: Size("delay at the end; two clocks, starts at 55 %", 16 * scale, "ms"),
        delay=lambda t, scale: 0.016 * scale * (first + (1 - first) * t / rig.seconds),
    )


def delay_packets(rng: np.random.Generator, rig: Rig) -> Fault:
    """A buffer of the network, and three samples to a packet."""
    n = int(rig.seconds / 0.05) + 2
    breathing = 0.25 * np.tanh(np.cumsum(rng.normal(size=n)) * 0.03)
    knots = np.arange(n) * 0.05

    def delay(t: Array, scale: float) -> Array:
        phase = (t % 0.012) / 0.012
        return np.asarray(0.018 * scale * (1 + np.interp(t, knots, breathing)) + 0.004 * np.floor(phase * 3) / 3)

    return Fault(
        size=lambda scale: Size("mean delay; network buffer that breathes +-25 %", 18 * scale, "ms"),
        delay=delay,
    )


def delay_const2(_: np.random.Generator, __: Rig) -> Fault:
    """Nearly constant."""
    return Fault(
        size=lambda scale: Size("delay, slowly breathing 12 %", 12 * scale, "ms"),
        delay=lambda t, scale: 0.012 * scale * (1 + 0.12 * np.sin(2 * np.pi * t / 17.0)),
    )


def lp_cascade(_: np.random.Generator, __: Rig) -> Fault:
    """Three lags one behind the other."""
    tau_s = np.array([1, 1, 1.25, 0.9, 0.9, 1.1]) * 0.02

    def lag_thrice(W: Array, scale: float) -> Array:
        each = [(W[:, i : i + 1], tau_s[i]) for i in range(6)]
        return np.stack([lag(lag(lag(x, tau * scale), tau * scale), 0.25 * tau * scale)[:, 0] for x, tau in each], 1)

    what = "RC cascade (two equal poles and a faster one), -3 dB about, fx"
    return Fault(size=lambda scale: Size(what, 0.63 / (2 * np.pi * 0.02 * scale), "Hz"), distort=lag_thrice)


def kin_ema(rng: np.random.Generator, rig: Rig) -> Fault:
    """A lag for each joint's reading."""
    tau_s = 0.022 * (0.6 + 0.8 * rng.random(rig.joint_count))
    what = "mean EMA time constant of joint readings (each joint its own)"
    return Fault(
        size=lambda scale: Size(what, 1e3 * scale * tau_s.mean(), "ms"),
        report_joints=lambda q, scale: lag_columns(q, scale * tau_s),
    )
