"""The sensor's zero moves: sun on its housing, a morning's warming, a bond that gives, a knock."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_zero
from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_time
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import lag, rise

SUN_K = 6.0


def _move_zero(zero: Array, shape: Array, what: str, told: Array | float) -> Fault:
    """By a zero (6,) that follows a shape (N, 6); told by its force where the shape is `told`."""
    size = float(np.linalg.norm((zero * told)[:3]))
    return Fault(size=lambda scale: Size(what, scale * size, "N"), distort=lambda W, scale: W + scale * zero * shape)


def _find_most(shape: Array) -> Array:
    """(6,), where a shape (N, 6) is farthest out."""
    return np.asarray(shape[np.argmax(np.sum(shape[:, :3] ** 2, axis=1))])


def drift_sun(rng: np.random.Generator, rig: Rig) -> Fault:
    """The sun comes through a roof light and goes: the housing follows soon, the beams late, and the log has the housing's temperature."""
    begin, end = rng.uniform(0.12, 0.22) * rig.seconds, rng.uniform(0.6, 0.72) * rig.seconds
    shone = (rise((rig.t - begin) / 4) - rise((rig.t - end) / 9))[:, None]
    housing, beams = lag(shone, 0.12 * rig.seconds), lag(lag(shone, 0.12 * rig.seconds), 0.25 * rig.seconds)
    zero, shape = draw_zero(rng, rig), housing - 0.5 * beams * rng.uniform(0, 1, 6)
    fault = _move_zero(zero, shape, "zero of the force moves with the sun, at most", _find_most(shape))
    return Fault(size=fault.size, distort=fault.distort, temperature=22.5 + SUN_K * housing[:, 0])


def drift_morning(rng: np.random.Generator, rig: Rig) -> Fault:
    """Switched on in the morning: the electronics warm soon and the body slowly, each channel its own way."""
    x = rig.t[:, None] / rig.seconds
    soon, slowly = 1 - np.exp(-x / 0.08), 1 - np.exp(-x / 0.7)
    shape = slowly * rng.uniform(0.7, 1.3, 6) + soon * rng.uniform(-0.6, 0.6, 6)
    return _move_zero(draw_zero(rng, rig), shape, "zero of the force moves while all warms, at most", _find_most(shape))


def step_bond(rng: np.random.Generator, rig: Rig) -> Fault:
    """The bond of a gauge gives: a jump, and a tenth of it more in the seconds after."""
    since = rig.t - draw_time(rng, rig, 0.3, 0.7)
    shape = (since > 0) * (1 + 0.1 * (1 - np.exp(-np.maximum(since, 0) / 3)))
    return _move_zero(draw_zero(rng, rig), shape[:, None] * np.ones(6), "zero of the force jumps by", 1.0)


def step_knock(rng: np.random.Generator, rig: Rig) -> Fault:
    """A knock in passing leaves another zero behind, after a short ring."""
    since = np.maximum(rig.t - draw_time(rng, rig, 0.35, 0.7, "transfer"), 0)
    shape = 1 - np.exp(-since / 0.04) * np.cos(2 * np.pi * 21 * since)
    return _move_zero(draw_zero(rng, rig), shape[:, None] * np.ones(6), "zero of the force jumps by", 1.0)
