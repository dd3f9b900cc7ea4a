"""The sensor's zero moves: drift and jumps of its offset."""

from __future__ import annotations

import numpy as np
from scipy import signal
from scipy.ndimage import gaussian_filter1d

from bench.stranger.draws import draw_direction, draw_sign
from bench.stranger.fault import Fault
from bench.stranger.rig import Rig
from bench.stranger.signals import draw_wander, lag_once, step_softly


def drift_at_random(rng: np.random.Generator, rig: Rig) -> Fault:
    """A random walk upon a line."""
    noise_std = rig.sensor.noise_std
    y = draw_wander(rng, rig.t, rig.seconds, 6, 1.5)
    y = y / np.ptp(y, axis=0) + np.outer(rig.t / rig.seconds, rng.normal(size=6))
    A = noise_std * rng.uniform(5, 14, 6) * (rng.random(6) < 0.7)
    A[2] = max(A[2], noise_std[2] * 8)
    return Fault(
        family="sensor_drift",
        variant="random walk plus linear trend, most channels",
        size=lambda scale: {"range_N_Nm": np.ptp(y * A * scale, axis=0)},
        put_out=lambda W, scale: W + y * A * scale,
    )


def warm_up(rng: np.random.Generator, rig: Rig) -> Fault:
    """The offset follows a temperature that is recorded."""
    t = np.maximum(rig.t, 0)
    fast_s, slow_s = rng.uniform(12, 30), rng.uniform(150, 500)
    T = 24 + 5 * (1 - np.exp(-t / fast_s)) + 9 * (1 - np.exp(-t / slow_s))
    inside = lag_once(T, rng.uniform(5, 12))
    A = rig.sensor.noise_std * rng.normal(size=6) * 3
    A[rng.integers(3)] *= 2.0
    return Fault(
        family="sensor_drift",
        variant="warm-up: two thermal exponentials, offset follows temperature with its own lag; temperature column given",
        size=lambda scale: {"per_K": A * scale, "tau_s": [fast_s, slow_s], "rise_K": np.ptp(T)},
        put_out=lambda W, scale: W + (inside - 24)[:, None] * A * scale,
        temperature=T,
    )


def follow_air_conditioning(rng: np.random.Generator, rig: Rig) -> Fault:
    """The hall's temperature goes up and down, and nothing records it."""
    noise_std = rig.sensor.noise_std
    period_s = rng.uniform(35, 60)
    y = signal.sawtooth(2 * np.pi / period_s * rig.t + rng.uniform(0, 6), 0.35)
    y = gaussian_filter1d(y, 2500) + 0.4 * draw_wander(rng, rig.t, rig.seconds, 1, 3)[:, 0] / 6
    A = noise_std * rng.normal(size=6) * 5 * (rng.random(6) < 0.6)
    place = rng.integers(6)
    A[place] = A[0] if A.any() else 8 * noise_std[0]
    A[3] += 7 * noise_std[3]
    return Fault(
        family="sensor_drift",
        variant="temperature cycling of the hall (skewed triangle of 35-60 s) plus wander, no temperature column",
        size=lambda scale: {"amplitude": A * scale, "period_s": period_s},
        put_out=lambda W, scale: W + y[:, None] * A * scale,
    )


def jump_and_relax(rng: np.random.Generator, rig: Rig) -> Fault:
    """A knock, of which a quarter goes away by itself."""
    at_s = rng.uniform(0.3, 0.7) * rig.seconds
    since = rig.t - at_s
    y = step_softly(rig.t, at_s, 0.05) * (0.75 + 0.25 * np.exp(-np.maximum(since, 0) / 9))
    force = draw_direction(rng) * 1.1
    A = np.r_[force, draw_direction(rng) * 0.05]
    return Fault(
        family="sensor_offset_step",
        variant="jump after a knock at t0 (0.2 s wide), a quarter of it relaxes with 9 s",
        size=lambda scale: {"t0": at_s, "step": A * scale},
        put_out=lambda W, scale: W + y[:, None] * A * scale,
    )


def jump(rng: np.random.Generator, rig: Rig) -> Fault:
    """From one sample to the next, one force and one torque."""
    at_s = rng.uniform(0.25, 0.75) * rig.seconds
    A = np.zeros(6)
    A[rng.integers(3)] = draw_sign(rng) * rng.uniform(0.5, 1.5)
    A[3 + rng.integers(3)] = draw_sign(rng) * 0.03
    return Fault(
        family="sensor_offset_step",
        variant="jump between two samples (loose contact in the amplifier), two channels",
        size=lambda scale: {"t0": at_s, "step": A * scale},
        put_out=lambda W, scale: W + (rig.t > at_s)[:, None] * A * scale,
    )
