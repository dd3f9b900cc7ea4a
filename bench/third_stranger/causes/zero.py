"""The sensor's zero moves: heat that comes through the flange or from motors, and a tare that is repeated."""

from __future__ import annotations

import numpy as np
from scipy.special import erfc

from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_offset, measure_force
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import derive, lag
from bench.third_stranger.draws import list_pauses


def drift_soak(rng: np.random.Generator, rig: Rig) -> Fault:
    """Heat of a hot workpiece soaks through the flange from some time on, and less after it is put down."""
    d, begin_s, depth_s = draw_offset(rng), rng.uniform(0.12, 0.3) * rig.seconds, rng.uniform(0.06, 0.15) * rig.seconds
    end_s = rng.uniform(0.7, 0.85) * rig.seconds
    shape = _soak(rig.t - begin_s, depth_s) - 0.8 * _soak(rig.t - end_s, depth_s)
    return Fault(
        size=lambda scale: Size(
            f"heat soaks in from {begin_s:.0f} s (diffusion) to {end_s:.0f} s, peak of force", scale * measure_force(d), "N"
        ),
        distort=lambda W, scale: W + scale * np.outer(shape / shape.max(), d),
    )


def _soak(since_s: Array, depth_s: float) -> Array:
    """(N,), the warmth below a surface that is hot from a time on, so many s ago."""
    return np.asarray(erfc(np.sqrt(depth_s / np.maximum(since_s, 1e-3))))


def drift_motors(rng: np.random.Generator, rig: Rig) -> Fault:
    """The motors of the wrist warm the sensor when they work, and air cools it; a temperature is recorded that is later still."""
    d, dq = draw_offset(rng), derive(rig.q)
    work = np.sum(dq[:, -2:] ** 2, 1) + 0.3 * np.sum(dq[:, :-2] ** 2, 1)
    slow_s = 0.35 * rig.seconds
    warm = lag(lag(work[:, None], slow_s), 3.0)[:, 0]
    warm = (warm - warm[0]) / np.ptp(warm)
    return Fault(
        size=lambda scale: Size("offset by the warmth of the wrist's motors, force from coldest to warmest", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(warm, d),
        temperature=27.5 + 3.1 * lag(warm[:, None], 5.0)[:, 0],
    )


def drift_settling(rng: np.random.Generator, rig: Rig) -> Fault:
    """After the lid of the cabinet was shut: two channels one way and the rest hardly, by a stretched exponential."""
    d = draw_offset(rng) * rng.permutation([1, 1, 0.2, 0.3, 1, 0.1])
    shape = 1 - np.exp(-((rig.t / (0.4 * rig.seconds)) ** 0.6))
    return Fault(
        size=lambda scale: Size("stretched-exponential warm-up, force", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(shape, d),
    )


def drift_after_pick(rng: np.random.Generator, rig: Rig, pick_s: float) -> Fault:
    """The part that is picked at a time, s, is hot."""
    d, depth_s = draw_offset(rng), rng.uniform(0.06, 0.12) * rig.seconds
    shape = _soak(rig.t - pick_s - 1.0, depth_s)
    return Fault(
        size=lambda scale: Size("heat of the picked part soaks in (diffusion), force at the end", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(shape / shape[-1], d),
    )


def step_tare(rng: np.random.Generator, rig: Rig) -> Fault:
    """Somebody sets the zero anew while the recorder pauses."""
    at_s, d = list_pauses(rig)[0], draw_offset(rng)
    return Fault(
        size=lambda scale: Size(f"zero set anew in a pause at {at_s:.1f} s, force", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(rig.t > at_s, d),
    )


def tare_after_regrip(rng: np.random.Generator, rig: Rig, pause_s: float) -> Fault:
    """The zero is set anew, some time, s, after which the part was gripped anew."""
    d = draw_offset(rng)
    return Fault(
        size=lambda scale: Size("zero set anew in the same pause, force", scale * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(rig.t > pause_s + 0.2, d),
    )
