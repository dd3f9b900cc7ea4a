"""Rotation matrices from angles and from rotation vectors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from bench.stranger.array import Array


def rotate_about_x(angle: float) -> Array:
    """(3, 3), by an angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def rotate_about_y(angle: float) -> Array:
    """(3, 3), by an angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rotate_about_z(angle: float) -> Array:
    """(3, 3), by an angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def rotate_by_rpy(angles: Sequence[float]) -> Array:
    """(3, 3), of roll, pitch and yaw in rad as URDF means them: about the fixed axes x, y, z in this order."""
    return np.asarray(rotate_about_z(angles[2]) @ rotate_about_y(angles[1]) @ rotate_about_x(angles[0]))


def rotate_by_vector(v: Array) -> Array:
    """(3, 3), of a rotation vector (3,) in rad, by Rodrigues' formula."""
    angle = np.linalg.norm(v)
    if angle < 1e-14:
        return np.eye(3)
    k = v / angle
    K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K)


def turn_vector(v: Array, by: Array) -> Array:
    """(N, 3), a vector (3,) turned by rotation vectors (N, 3) in rad."""
    angle = np.linalg.norm(by, axis=1)[:, None] + 1e-15
    axis = by / angle
    return np.asarray(v * np.cos(angle) + np.cross(axis, v) * np.sin(angle) + axis * (axis @ v)[:, None] * (1 - np.cos(angle)))
