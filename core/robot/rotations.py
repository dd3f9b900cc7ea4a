"""Rotations in space and differences of poses, compiled, for the loops that run at every sample."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array


@njit(cache=True)
def exponential(v: Array, R: Array) -> None:
    """Fills R (3, 3) with the rotation of a rotation vector (3,)."""
    square = v[0] ** 2 + v[1] ** 2 + v[2] ** 2
    angle = np.sqrt(square)
    s, c = (1.0 - square / 6.0, 0.5 - square / 24.0) if angle < 1e-4 else (np.sin(angle) / angle, (1.0 - np.cos(angle)) / square)
    for i in range(3):
        for j in range(3):
            R[i, j] = c * v[i] * v[j]
        R[i, i] += 1.0 - c * square
    R[2, 1] += s * v[0]
    R[1, 2] -= s * v[0]
    R[0, 2] += s * v[1]
    R[2, 0] -= s * v[1]
    R[1, 0] += s * v[2]
    R[0, 1] -= s * v[2]


@njit(cache=True)
def logarithm(R: Array, v: Array) -> None:
    """Fills v (3,) with the rotation vector of a rotation (3, 3) by less than pi."""
    v[0], v[1], v[2] = 0.5 * (R[2, 1] - R[1, 2]), 0.5 * (R[0, 2] - R[2, 0]), 0.5 * (R[1, 0] - R[0, 1])
    sine = np.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2)
    if sine > 1e-9:
        factor = np.arctan2(sine, 0.5 * (R[0, 0] + R[1, 1] + R[2, 2] - 1.0)) / sine
        for i in range(3):
            v[i] *= factor


@njit(cache=True)
def pose_error(R: Array, p: Array, rotation: Array, position: Array, e: Array) -> None:
    """Fills e (6,) with the way from the pose (R, p) to the wanted one, in the axes of R: translation, then rotation vector."""
    E = np.empty((3, 3))
    for i in range(3):
        e[i] = R[0, i] * (position[0] - p[0]) + R[1, i] * (position[1] - p[1]) + R[2, i] * (position[2] - p[2])
        for k in range(3):
            E[i, k] = R[0, i] * rotation[0, k] + R[1, i] * rotation[1, k] + R[2, i] * rotation[2, k]
    logarithm(E, e[3:])
