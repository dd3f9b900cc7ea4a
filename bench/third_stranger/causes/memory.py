"""What the sensor reads depends on what was before: a seal that sticks, glue that creeps."""

from __future__ import annotations

import numpy as np
from scipy.signal import fftconvolve

from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S

EVERY = 10
"""Steps of the grid."""


def hyst_seal(rng: np.random.Generator, rig: Rig) -> Fault:
    """A seal bridges the sensor: parts of it stick, slip when they are pulled too far, and slowly let go while nothing moves."""
    most = np.maximum(np.abs(rig.load).max(0), 1e-6)
    reaches = np.array([0.08, 0.2, 0.45])[:, None] * rng.uniform(0.8, 1.2, 6)
    kept = np.exp(-EVERY * STEP_S / np.array([20.0, 60.0, 240.0]))[:, None]
    z, sticks = np.zeros((3, 6)), np.zeros((len(rig.load[::EVERY]), 6))
    steps = np.diff(rig.load[::EVERY] / most, axis=0, prepend=rig.load[:1] / most)
    for i, step in enumerate(steps):
        z = np.clip(z * kept + step, -reaches, reaches)
        sticks[i] = z.sum(0)
    share = np.array([1, 1.1, 0.8, 0.9, 1, 0.5]) * most
    memory = np.stack([np.interp(rig.t, rig.t[::EVERY], sticks[:, i]) for i in range(6)], 1) * share
    return Fault(
        size=lambda scale: Size("seal beside the sensor sticks and slips, half opening", 0.73 * scale, "% of peak load"),
        distort=lambda W, scale: W - 0.01 * scale * memory,
    )


def creep_glue(rng: np.random.Generator, rig: Rig) -> Fault:
    """Glue under the gauges creeps by a power of time, and still creeps from what was before the recording."""
    exponent, history_s = rng.uniform(0.22, 0.3), 240.0
    share = np.array([0.7, 0.8, 1.3, 1.0, 0.9, 0.4])
    coarse_s = 0.05
    every = round(coarse_s / STEP_S)
    coarse = rig.load[::every]
    other = np.mean(rig.load, axis=0) - 0.6 * np.std(rig.load, axis=0)
    before = np.tile(other, (int(history_s / coarse_s), 1))
    steps = np.diff(np.vstack([before, coarse]), axis=0, prepend=before[:1])
    answer = (np.arange(len(steps)) * coarse_s / 60) ** exponent
    crept = np.stack([fftconvolve(steps[:, i], answer)[len(before) : len(steps)] for i in range(6)], 1)
    late = np.stack([np.interp(rig.t, rig.t[::every], crept[:, i]) for i in range(6)], 1)
    return Fault(
        size=lambda scale: Size(f"creep by t^{exponent:.2f}, after a minute (fz 1.3 times)", scale, "% of load"),
        distort=lambda W, scale: W + 0.01 * scale * share * late,
    )
