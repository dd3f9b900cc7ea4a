"""Wrench and joints are not of the same moment: delays, filters, and joints that are averaged."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import uniform_filter1d

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S

ADAPTED_EVERY = 4
"""Steps of the grid."""


def delay_resync(rng: np.random.Generator, rig: Rig) -> Fault:
    """Two clocks are set to each other in the middle of the recording, which halves what is between them."""
    at_s = rng.uniform(0.4, 0.6) * rig.seconds
    return Fault(
        size=lambda scale: Size(f"delay, 45 % of it after the clocks were set at {at_s:.0f} s", 20 * scale, "ms"),
        delay=lambda t, scale: 0.02 * scale * np.where(t < at_s, 1.0, 0.45),
    )


def delay_bus(rng: np.random.Generator, _: Rig) -> Fault:
    """The wrench waits for the bus: some cycles, and now and then some more."""
    waits = rng.choice([0, 0, 0, 1, 1, 2, 4], 4096)

    def wait(t: Array, scale: float) -> Array:
        cycle_s = 0.008 * scale
        return np.asarray(cycle_s * (4 + 0.5 * waits[(t / 0.25).astype(int) % len(waits)]))

    return Fault(size=lambda scale: Size("waits four cycles of a bus and at times two more, cycle", 8 * scale, "ms"), delay=wait)


def lp_adaptive(_: np.random.Generator, rig: Rig) -> Fault:
    """A filter in the sensor that is slow at rest and four times as fast when the load changes much."""
    quick = 12 * rig.noise_std

    def follow(W: Array, scale: float) -> Array:
        slowest = 1 - np.exp(-2 * np.pi * 5.0 / scale * ADAPTED_EVERY * STEP_S)
        read = W[::ADAPTED_EVERY]
        y, followed = read[0].copy(), np.empty_like(read)
        for i, w in enumerate(read):
            off = w - y
            y = y + np.minimum(slowest * (1 + 3 * off * off / (off * off + quick * quick)), 1.0) * off
            followed[i] = y
        return np.stack([np.interp(rig.t, rig.t[::ADAPTED_EVERY], followed[:, i]) for i in range(6)], 1)

    return Fault(
        size=lambda scale: Size("first-order filter, four times as fast when the load changes much; corner at rest", 5 / scale, "Hz"),
        distort=follow,
    )


def kin_box(rng: np.random.Generator, rig: Rig) -> Fault:
    """The controller reports the mean of each joint over a window that lies behind; wider for the big joints."""
    windows_s = 0.05 * rng.uniform(0.8, 1.2, rig.joint_count)
    windows_s[2:] *= 0.7

    def average(q: Array, scale: float) -> Array:
        averaged = q.copy()
        for j, window_s in enumerate(windows_s):
            n = max(1, round(window_s * scale / STEP_S))
            averaged[:, j] = uniform_filter1d(q[:, j], n, mode="nearest", origin=(n - 1) // 2)
        return averaged

    return Fault(
        size=lambda scale: Size("joints are means over windows that lie behind, window of joint 1", 1e3 * scale * windows_s[0], "ms"),
        report_joints=average,
    )
