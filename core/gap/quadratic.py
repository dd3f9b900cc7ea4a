"""Quadratic minima, scaled so that parameters of very different units do not spoil the arithmetic."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ACTIVE_SET_PASSES = 6


def bounded_minimum(normal: Array, right: Array, bounds: Array) -> Array:
    """Minimum of the quadratic within bounds (2, n): what leaves them is held there, and the rest solved again."""
    d = np.zeros(len(right))
    free = np.ones(len(right), dtype=bool)
    for _ in range(ACTIVE_SET_PASSES):
        d[free] = solved(normal[np.ix_(free, free)], right[free] - normal[np.ix_(free, ~free)] @ d[~free])
        outside = free & ((d < bounds[0]) | (d > bounds[1]))
        if not outside.any():
            break
        d = np.clip(d, bounds[0], bounds[1])
        free &= ~outside
    return np.clip(d, bounds[0], bounds[1])


def solved(matrix: Array, right: Array) -> Array:
    """Solution of a symmetric positive definite system."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    return np.asarray(np.linalg.solve(matrix * np.outer(scale, scale), right * scale) * scale)


def inverse(matrix: Array) -> Array:
    """Inverse of a symmetric positive definite matrix."""
    scale = 1.0 / np.sqrt(np.diag(matrix))
    return np.asarray(np.linalg.inv(matrix * np.outer(scale, scale)) * np.outer(scale, scale))
