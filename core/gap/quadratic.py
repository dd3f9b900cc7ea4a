"""Quadratic minima, scaled so that parameters of very different units do not spoil the arithmetic."""

from __future__ import annotations

import numpy as np
from scipy.optimize import lsq_linear

from core.array import Array

LEAST_EIGENVALUE = 1e-15
"""Of the scaled matrix, relative to the largest; what is smaller is rounding."""


def find_bounded_minimum(normal: Array, right: Array, bounds: Array) -> Array:
    """The x (n,) within bounds (2, n) that minimises x' normal x / 2 - right' x.

    Args:
        normal: (n, n), symmetric positive definite.

    With bounds that bind, by the active sets of Stark and Parker 1995 (`scipy.optimize.lsq_linear`).
    """
    free = solve_scaled(normal, right)
    if ((free >= bounds[0]) & (free <= bounds[1])).all():
        return free
    scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-300))
    values, vectors = np.linalg.eigh(normal * np.outer(scale, scale))
    root = np.sqrt(np.maximum(values, LEAST_EIGENVALUE * values[-1]))
    found = lsq_linear(
        root[:, None] * vectors.T,
        (vectors.T @ (right * scale)) / root,
        (bounds[0] / scale, bounds[1] / scale),
        method="bvls",
        tol=1e-14,
        max_iter=100 * len(right),
    )
    return np.clip(found.x * scale, bounds[0], bounds[1])


def solve_scaled(matrix: Array, right: Array) -> Array:
    """Solution of a symmetric positive definite system."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    return np.asarray(np.linalg.solve(matrix * np.outer(scale, scale), right * scale) * scale)


def inverse(matrix: Array) -> Array:
    """Inverse of a symmetric positive definite matrix."""
    scale = 1.0 / np.sqrt(np.diag(matrix))
    return np.asarray(np.linalg.inv(matrix * np.outer(scale, scale)) * np.outer(scale, scale))
