"""Slow drift of the sensor's offset as a random walk whose strength the data decide (restricted maximum likelihood).

Across a pause the offset may jump: a sensor drifts between two runs, and may be tared. That is a step of its own and tells nothing about
the walk.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.array import Array
from core.recording.recording import PAUSE_S

SPACING_S = 6.0
"""Between the knots of the walk; linear in between."""
LARGEST_KNOTS = 40
STEP_STD = np.repeat([1.0, 0.05], 3)
"""N and N m, of the offsets of what was recorded after a pause against those before it."""

Part = tuple[float, float]
"""First and last time of what was recorded without a pause, s."""


def parts_of(t: Array) -> list[Part]:
    """Of a recording with sample times t (N,)."""
    edges = np.flatnonzero(np.diff(t) > PAUSE_S) + 1
    return [(float(rows[0]), float(rows[-1])) for rows in np.split(t, edges)]


def drift_basis(t: Array, parts: Sequence[Part]) -> Array:
    """(K, n) ramps, one for each increment of the walk, each with mean zero over the times t (K,)."""
    spacing = max(SPACING_S, sum(stop - start for start, stop in parts) / LARGEST_KNOTS)
    ramps = [np.zeros((len(t), 0))]
    for start, stop in parts:
        count = round((stop - start) / spacing)
        if count >= 2:
            knots = np.linspace(start, stop, count + 1)
            ramps.append(np.clip((t[:, None] - knots[:-1]) / np.diff(knots), 0.0, 1.0))
    return _centre(np.concatenate(ramps, axis=1))


def steps_between(t: Array, parts: Sequence[Part]) -> Array:
    """(K, p) steps of height 1 where a part begins, for those with some of the times t (K,), each with mean zero over them."""
    part = np.searchsorted([start for start, _ in parts], t, side="right")
    return _centre(np.asarray(part[:, None] >= np.unique(part)[1:], dtype=np.float64))


def _centre(columns: Array) -> Array:
    return np.asarray(columns - columns.mean(axis=0)) if len(columns) else columns


def improve_variance(variance: float, z: Array, covariance: Array, floor: float) -> float:
    """One step of Fellner and Schall towards the variance of the increments z (n,), given their posterior covariance.

    The fixed point maximises the restricted likelihood (Wood & Fasiolo 2017, Biometrics 73).
    """
    seen = len(z) - float(np.trace(covariance)) / variance
    return max(floor, float(z @ z) / max(seen, 1e-6))
