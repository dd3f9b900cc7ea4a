"""Rotation matrices and small tilts."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from bench.second_stranger.array import Array


def rotate_by_vector(v: Array) -> Array:
    """(3, 3), of a rotation vector (3,) in rad."""
    return np.asarray(pin.exp3(v))


def find_cross_matrix(v: Array) -> Array:
    """(3, 3), by which v x is a product."""
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def tilt_vectors(v: Array, about_x: Array, about_y: Array) -> Array:
    """(N, 3), vectors (N, 3) turned by rotation vectors whose x and y are angles (N,) in rad."""
    by = np.stack([about_x, about_y, 0 * about_x], 1)
    angle = np.linalg.norm(by, axis=1, keepdims=True) + 1e-15
    axis = by / angle
    along = np.sum(axis * v, 1, keepdims=True)
    return np.asarray(v * np.cos(angle) + np.cross(axis, v) * np.sin(angle) + axis * along * (1 - np.cos(angle)))
