"""Random parameters of plausible faults."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.plant.faults.fault import Setting, Six, Three


def draw_log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    """Log-uniform between two positive limits."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def sign(rng: np.random.Generator) -> float:
    """-1 or 1."""
    return float(rng.choice([-1.0, 1.0]))


def direction(rng: np.random.Generator) -> Array:
    """(3,), a unit vector, all alike."""
    v = rng.standard_normal(3)
    return np.asarray(v / np.linalg.norm(v))


def three(v: Array) -> Three:
    """As plain numbers."""
    x, y, z = (float(value) for value in v)
    return x, y, z


def six(v: Array) -> Six:
    """As plain numbers."""
    a, b, c, d, e, f = (float(value) for value in v)
    return a, b, c, d, e, f


def wrench_of(rng: np.random.Generator, force_n: float, setting: Setting) -> Six:
    """A force of that size in some direction, and a torque of the same share of the sensor's range."""
    torque = force_n * setting.full_scale[3] / setting.full_scale[0]
    return six(np.concatenate((force_n * direction(rng), torque * direction(rng))))


def channels(rng: np.random.Generator, most: int = 6) -> Array:
    """(6,) of 0 and 1: one channel as often as several, at most `most`."""
    count = 1 if rng.random() < 0.5 else int(rng.integers(2, most + 1))
    chosen = np.zeros(6)
    chosen[rng.permutation(6)[:count]] = 1.0
    return chosen


def draw_signed_log_uniform(rng: np.random.Generator, low: float, high: float, count: int) -> Array:
    """(count,), each log-uniform between the limits with either sign."""
    return np.array([sign(rng) * draw_log_uniform(rng, low, high) for _ in range(count)])


def some_joints(rng: np.random.Generator, n: int, most: int) -> Array:
    """(n,) of 0 and 1: from one to `most` joints."""
    chosen = np.zeros(n)
    chosen[rng.permutation(n)[: int(rng.integers(1, most + 1))]] = 1.0
    return chosen


def seed_of(rng: np.random.Generator) -> int:
    """For what is random within the run."""
    return int(rng.integers(2**31))


def moment(rng: np.random.Generator, setting: Setting) -> float:
    """A time well inside the run, s."""
    return float(rng.uniform(0.15, 0.8) * setting.seconds)
