"""The offset follows a heating that is switched on and off: a hall, a cabinet, a gripper's drive with a thermostat."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.channels import amplitudes, expand_to_channels
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_drift import SensorDrift
from core.effects.vectors import add_course
from core.effects.window_search import weights

SHORTEST_S, SHORTEST, LONGEST, CYCLES = 8.0, 0.1, 1.5, 20
"""Cycles that are looked at: from s and such a share of the run up to so many lengths of it,"""
PHASES, CONSTANTS_S = 10, (10.0, 30.0, 90.0)
"""in so many phases, with some time constants,"""
ROWS = 400
"""in no more rows than about this many."""
SIGN = 0.3
"""Share of the residual's square that the best one explains, or there is no sign of any."""
QUICKEST_S = 5.0
"""Of what warms a sensor's body; what follows more quickly is a jump of the offset."""
START_N = 0.5
"""Of the largest offset."""


class DriftWithHeating(SensorDrift):
    """`W = w + A v`, `T v' = u - v` from v = 0 at the start on; u is 1 in the first half of each cycle, counted from `t1`, else 0."""

    wider_shape = True
    followed = 4

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Offset where it stays on (6), N and N m, cycle, a time at which it is switched on, and time constant, s."""
        seconds = max(float(scene.t[-1] - scene.t[0]), SHORTEST_S)
        shortest = max(SHORTEST_S, SHORTEST * seconds)
        return (
            *amplitudes("hot", bound=expand_to_channels(50.0, 2.5), scale=expand_to_channels(1.0, 0.05)),
            Parameter("cycle_s", "s", seconds, 0.5 * shortest, 3.0 * seconds, 0.2 * seconds),
            Parameter("at_s", "s", 0.0, -3.0 * seconds, 3.0 * seconds, 0.1 * seconds),
            Parameter("time_constant_s", "s", 30.0, QUICKEST_S, 300.0, 20.0),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the offset by then."""
        return np.asarray(add_course(w, _warm(scene.elapsed, *theta[6:]), theta[:6]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The courses that explain most of the residual; none where none explains much."""
        rows = slice(0, None, max(1, len(scene) // ROWS))
        seen = residual[rows]
        best = heapq.nlargest(self.followed, _find_courses(scene.elapsed[rows], seen), key=lambda course: course.explained)
        if best[0].explained <= SIGN * float(np.square(seen - seen.mean(axis=0)).sum()):
            return []
        offsets = [course.along / weights(scene) for course in best]  # up to a factor: the residual's unit is not known
        return [np.concatenate((START_N * x / np.abs(x).max(), course.warm)) for x, course in zip(offsets, best, strict=True)]

    def find_drift(self, scene: Scene, theta: Array) -> Array:
        """(6,), N and N m, the most that it changes in the run."""
        return np.asarray(theta[:6] * np.ptp(_warm(scene.elapsed, *theta[6:])))


def _warm(t: Array, cycle: float, first: float, constant: float) -> Array:
    """(N,), how warm it is, 0 to 1, at times t from 0 on: cold at 0, switched at `first` and each half cycle before and after."""
    half = 0.5 * cycle
    switch = math.ceil(-first / half)  # the first one that is not before 0
    warmth = np.zeros_like(t) if switch % 2 == 0 else -np.expm1(-t / constant)
    for k in range(switch, switch + math.ceil(float(t[-1]) / half) + 1):
        warmth -= (-1.0) ** k * np.expm1(-np.maximum(t - first - k * half, 0.0) / constant)
    return warmth


class _Course(NamedTuple):
    """What a course of the warmth explains of a residual (square), its three parameters, and the amplitudes (6,) in the residual's unit."""

    explained: float
    warm: tuple[float, float, float]
    along: Array


def _find_courses(t: Array, seen: Array) -> Iterator[_Course]:
    """Of a residual (N, 6), channels by themselves, beside their means."""
    seconds = float(t[-1])
    seen = seen - seen.mean(axis=0)
    for cycle in np.geomspace(max(SHORTEST_S, SHORTEST * seconds), max(LONGEST * seconds, SHORTEST_S), CYCLES):
        for at in cycle * np.arange(PHASES) / PHASES:
            for constant in CONSTANTS_S:
                warm = _warm(t, float(cycle), float(at), constant)
                warm -= warm.mean()
                power = float(warm @ warm)
                along = warm @ seen / max(power, 1e-12)
                yield _Course(power * float(along @ along), (float(cycle), float(at), constant), along)
