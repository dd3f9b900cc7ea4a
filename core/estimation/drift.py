"""Slow drift of the sensor's offset as a random walk whose strength the data decide (restricted maximum likelihood)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SPACING_S = 6.0
"""Between the knots of the walk; linear in between."""
LARGEST_KNOTS = 40


def drift_basis(t: Array, *, start: float, stop: float) -> Array:
    """(K, n) ramps, one for each increment of the walk, each with mean zero over the times t (K,)."""
    count = int(min(LARGEST_KNOTS, round((stop - start) / SPACING_S)))
    if count < 2:
        return np.zeros((len(t), 0))
    knots = np.linspace(start, stop, count + 1)
    ramps = np.clip((t[:, None] - knots[:-1]) / np.diff(knots), 0.0, 1.0)
    return np.asarray(ramps - ramps.mean(axis=0))


def improved_variance(variance: float, z: Array, covariance: Array, floor: float) -> float:
    """One step of Fellner and Schall towards the variance of the increments z (n,), given their posterior covariance.

    The fixed point maximises the restricted likelihood (Wood & Fasiolo 2017, Biometrics 73).
    """
    seen = len(z) - float(np.trace(covariance)) / variance
    return max(floor, float(z @ z) / max(seen, 1e-6))
