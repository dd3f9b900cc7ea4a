"""Draws that several causes have in common."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.motions import Stretch
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S, derive


def draw_direction(rng: np.random.Generator) -> Array:
    """(3,), of length 1."""
    return normalise(rng.normal(size=3))


def draw_zero(rng: np.random.Generator, rig: Rig) -> Array:
    """(6,), N and N m: an offset of the length of ten noises, which no channel is without."""
    return np.asarray(10 * rig.noise_std * normalise(rng.choice([-1, 1], 6) * rng.uniform(0.3, 1, 6)))


def list_stretches(rig: Rig, doing: str, low: float, high: float) -> list[Stretch]:
    """Those whose label begins so and whose middle lies between shares of the recording."""
    return [each for each in rig.stretches if each.label.startswith(doing) and low < (each.begin_s + each.end_s) / 2 / rig.seconds < high]


def draw_stretch(rng: np.random.Generator, rig: Rig, doing: str, low: float, high: float) -> Stretch:
    """One of these."""
    fitting = list_stretches(rig, doing, low, high)
    return fitting[int(rng.integers(len(fitting)))]


def find_speed_of_joints(rig: Rig) -> Array:
    """(N,), rad/s, of all joints together."""
    return np.asarray(np.linalg.norm(derive(rig.q), axis=1))


def spread_over_grid(rig: Rig, coarse: Array, every: int) -> Array:
    """(N, k), what is known (C, k) at every so many steps of the grid."""
    return np.stack([np.interp(rig.t, rig.t[::every], column) for column in coarse.T], 1)


def step_of(every: int) -> float:
    """s, of so many steps of the grid."""
    return every * STEP_S
