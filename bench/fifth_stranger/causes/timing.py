"""Wrench and joints do not belong to the same instant: cycles that beat, a queue, averages, oil, an observer in the drives."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import uniform_filter1d

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S, lag_columns, resonate, rise


def delay_beat(rng: np.random.Generator, _: Rig) -> Fault:
    """Sensor and controller run on clocks of their own: a steady delay, and a part of a cycle more that grows and falls back."""
    period_s = rng.uniform(6, 11)
    return Fault(
        size=lambda scale: Size("delay on the average", 12 * scale, "ms"),
        delay=lambda times, scale: 0.012 * scale * (0.85 + 0.3 * np.mod(times / period_s, 1)),
    )


def delay_queue(rng: np.random.Generator, rig: Rig) -> Fault:
    """The driver's queue is longer while another program is busy, for a third of the time."""
    begin, length = rng.uniform(0.25, 0.4) * rig.seconds, 0.33 * rig.seconds

    def wait(times: Array, scale: float) -> Array:
        busy = rise((times - begin) / 2) - rise((times - begin - length) / 4)
        return np.asarray(0.012 * scale * (1 + 0.4 * busy))

    return Fault(size=lambda scale: Size("delay, by 0.4 longer for a third of the time", 12 * scale, "ms"), delay=wait)


def lp_average(_: np.random.Generator, __: Rig) -> Fault:
    """The amplifier averages over a window, and the bus module over another one half as long."""

    def average(W: Array, scale: float) -> Array:
        for share in (1, 0.5):
            count = 2 * max(1, round(0.06 * scale * share / STEP_S / 2)) + 1
            W = uniform_filter1d(W, count, axis=0, mode="nearest", origin=(count - 1) // 2)
        return W

    return Fault(size=lambda scale: Size("longer window of the average", 60 * scale, "ms"), distort=average)


def lp_oil(rng: np.random.Generator, _: Rig) -> Fault:
    """Oil between the beams damps what is fast, in each channel with a corner of its own."""
    taus_s = 0.03 * rng.uniform(0.6, 1.4, 6)
    return Fault(
        size=lambda scale: Size("time constant fx", 1e3 * scale * float(taus_s[0]), "ms"),
        distort=lambda W, scale: lag_columns(W, np.maximum(scale * taus_s, 1e-4)),
    )


def kin_observer(rng: np.random.Generator, rig: Rig) -> Fault:
    """What the drives report comes from an observer of second order that is slower in the wrist."""
    hz = 16 * np.linspace(1.3, 0.8, rig.joint_count) * rng.uniform(0.95, 1.05, rig.joint_count)

    def observe(q: Array, scale: float) -> Array:
        return np.concatenate([resonate(q[:, i : i + 1], float(f) / scale, 0.8) for i, f in enumerate(hz)], 1)

    late_ms = 1e3 * 2 * 0.8 / (2 * np.pi * float(hz[-1]))
    return Fault(size=lambda scale: Size("lag of the last joint", late_ms * scale, "ms"), report_joints=observe)
