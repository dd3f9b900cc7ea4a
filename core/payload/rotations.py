"""Rotations in space as matrices, in NumPy alone. What a control loop turns is compiled, in `core.robot.rotations`."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from core.array import Array


def skew(v: ArrayLike) -> Array:
    """Matrix of the cross product `v x`, shape (..., 3, 3)."""
    v = np.asarray(v, dtype=float)
    matrix = np.zeros((*v.shape[:-1], 3, 3))
    matrix[..., 0, 1], matrix[..., 0, 2], matrix[..., 1, 2] = -v[..., 2], v[..., 1], -v[..., 0]
    matrix[..., 1, 0], matrix[..., 2, 0], matrix[..., 2, 1] = v[..., 2], -v[..., 1], v[..., 0]
    return matrix


def cross(u: Array, v: Array) -> Array:
    """Cross product along the last axis, broadcast; `numpy.cross` takes five times as long."""
    x = u[..., 1] * v[..., 2] - u[..., 2] * v[..., 1]
    y = u[..., 2] * v[..., 0] - u[..., 0] * v[..., 2]
    z = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.stack((x, y, z), axis=-1)


def rotation_of(vector: Array) -> Array:
    """(3, 3), of a rotation vector (3,), rad: Rodrigues' formula, smooth at zero."""
    angle, K = np.linalg.norm(vector), skew(vector)
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * K + 0.5 * np.sinc(0.5 * angle / np.pi) ** 2 * (K @ K))


def rotate_by(vectors: Array, x: Array) -> Array:
    """(N, 3), the vector x (3,), or each of them (N, 3), rotated by each rotation vector (N, 3), rad, as `rotation_of` does."""
    angle, across = np.linalg.norm(vectors, axis=1, keepdims=True), cross(vectors, x)
    return np.asarray(x + np.sinc(angle / np.pi) * across + 0.5 * np.sinc(0.5 * angle / np.pi) ** 2 * cross(vectors, across))


def rotation_of_rpy(rpy: Array) -> Array:
    """(3, 3), of roll, pitch and yaw (3,), rad: Rz Ry Rx."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )
