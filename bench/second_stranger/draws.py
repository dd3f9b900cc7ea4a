"""Draws that several causes have in common."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.rig import Rig

CHANNELS = np.array([1, 1, 1, 0.03, 0.03, 0.03])
"""(6,), N and N m: how large an offset of torque is beside one of force."""


def normalise(v: Array | list[float]) -> Array:
    """A vector with length 1."""
    v = np.asarray(v, float)
    return np.asarray(v / np.linalg.norm(v))


def draw_offset(rng: np.random.Generator) -> Array:
    """(6,), N and N m."""
    return np.asarray(CHANNELS * rng.normal(size=6))


def measure_force(offset: Array) -> float:
    """N, how long the force of an offset (6,) is."""
    return float(np.linalg.norm(offset[:3]))


def draw_time(rng: np.random.Generator, rig: Rig, low: float, high: float, doing: str = "") -> float:
    """A time, s, in a stretch whose middle lies between shares of the recording and whose label begins so."""
    begin, end = low * rig.seconds, high * rig.seconds
    fitting = [each for each in rig.stretches if begin < (each.begin_s + each.end_s) / 2 < end and each.label.startswith(doing)]
    stretch = fitting[rng.integers(len(fitting))]
    return float(stretch.begin_s + (stretch.end_s - stretch.begin_s) * rng.uniform(0.35, 0.6))
