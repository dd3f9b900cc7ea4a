"""The sensor's zero moves: drift and jumps of its offset."""

from __future__ import annotations

import numpy as np
from scipy.signal import lfilter

from bench.second_stranger.array import Array
from bench.second_stranger.draws import CHANNELS, draw_offset, draw_time, measure_force
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S, lag, rise


def drift_overshoot(rng: np.random.Generator, rig: Rig) -> Fault:
    """The housing and the gauges warm up one after the other."""
    d = draw_offset(rng)
    fast_s, slow_s = rig.seconds * 0.10, rig.seconds * 0.55
    d2 = draw_offset(rng) * 0.5
    over = np.exp(-rig.t / slow_s) - np.exp(-rig.t / fast_s)
    shape = np.outer(over, d), np.outer(1 - np.exp(-rig.t / (rig.seconds * 0.4)), d2)
    return Fault(
        size=lambda scale: Size("thermal offset, peak of force", scale * 0.55 * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * (shape[0] + shape[1]),
    )


def drift_wander(rng: np.random.Generator, rig: Rig) -> Fault:
    """A random walk that comes back."""
    x = rng.normal(size=(len(rig.t) // 100 + 2, 6))
    x = lfilter([1], [1, -0.996], x, axis=0)
    x = lfilter([0.05], [1, -0.95], x, axis=0)
    x = x - x[:1]
    x = x / np.sqrt(np.mean(x**2))
    sizes = CHANNELS * (0.3 + rng.random(6))
    wander = np.stack([np.interp(rig.t, np.arange(len(x)) * 0.1, x[:, i]) for i in range(6)], 1) * sizes
    return Fault(
        size=lambda scale: Size("wandering offset rms, force", scale, "N"),
        distort=lambda W, scale: W + scale * wander,
    )


def drift_hvac(rng: np.random.Generator, rig: Rig) -> Fault:
    """The offset follows a thermostat, and so does a temperature that is recorded."""
    d = draw_offset(rng)
    T = lag(_run_thermostat(len(rig.t))[:, None], 4.0)[:, 0]
    return Fault(
        size=lambda scale: Size("peak-to-peak offset of force with thermostat cycle", scale * np.ptp(T) * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(T, d),
        temperature=23 + 1.2 * T,
    )


def _run_thermostat(count: int) -> Array:
    """(count,), from zero, about between -0.5 and 0.5: heated quickly and cooled slowly."""
    T = np.zeros(count)
    is_on, v = True, 0.0
    for i in range(1, count):
        v += STEP_S * ((2.2 - v) / 14 if is_on else (-2.0 - v) / 22)
        if v > 0.5:
            is_on = False
        if v < -0.5:
            is_on = True
        T[i] = v
    return T


def drift_log(rng: np.random.Generator, rig: Rig) -> Fault:
    """After the power was switched on."""
    d = draw_offset(rng)
    tau_s = 2 + 4 * rng.random(6)
    shape = np.log1p(rig.t[:, None] / tau_s) / np.log1p(rig.seconds / tau_s)
    return Fault(
        size=lambda scale: Size("log-time offset change after power-on, force", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * shape * d,
    )


def step_gauge(rng: np.random.Generator, rig: Rig) -> Fault:
    """A gauge comes loose, and rings."""
    at_s = draw_time(rng, rig, 0.35, 0.65)
    d = draw_offset(rng)
    since = np.maximum(rig.t - at_s, 0)
    ringing = np.exp(-since / 0.015) * np.cos(2 * np.pi * 9 * since) * np.exp(-since / 0.06)
    shape = np.where(rig.t - at_s > 0, 1 - ringing, 0)
    what = f"jump of force offset (one gauge, all channels), t0 {at_s:.1f} s"
    return Fault(
        size=lambda scale: Size(what, scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(shape, d),
    )


def step_settle(rng: np.random.Generator, rig: Rig) -> Fault:
    """A screw finds its seat during a turn."""
    at_s = draw_time(rng, rig, 0.35, 0.65, "rotate")
    d = CHANNELS * np.array([0.2, -1, 0.35, 1.0, 0.1, -0.4])
    shape = rise((rig.t - at_s) / 0.35)
    what = f"seat of a screw, jump of force offset at {at_s:.1f} s"
    return Fault(
        size=lambda scale: Size(what, scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(shape, d),
    )


def step_after_contact(rng: np.random.Generator, rig: Rig, contact_s: float) -> Fault:
    """A push that begins at a time, s, moves the zero."""
    d = draw_offset(rng)
    shape = rise((rig.t - contact_s - 0.4) / 0.08)
    return Fault(
        size=lambda scale: Size("zero jumps through the push, force", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(shape, d),
    )
