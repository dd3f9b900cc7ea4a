"""A mass at a point on a hand that turns and moves, by formulas of its own: what a log of it should hold."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array

MASS_KG = 1.3
LEVER_M = np.array([0.02, -0.03, 0.09])
UP = np.array([0.0, 0.0, 9.81])


@dataclass(frozen=True)
class PayloadLog:
    """t (N,), s; orientation (N, 3, 3) and position (N, 3), m, of the sensor; wrench (N, 6) that the sensor exerts on the payload."""

    t: Array
    orientation: Array
    position: Array
    wrench: Array


def angles_at(t: Array) -> Array:
    """(N, 3), rad, about fixed x, y and z."""
    return np.column_stack([0.9 * np.sin(0.7 * t), 0.7 * np.sin(0.5 * t + 1.0), 0.6 * np.sin(0.3 * t)])


def pose_at(t: Array) -> tuple[Array, Array]:
    """Orientation and position."""
    position = np.column_stack([0.2 * np.sin(0.6 * t), 0.1 * np.cos(0.4 * t), 0.5 + 0.15 * np.sin(0.5 * t)])
    return Rotation.from_euler("xyz", angles_at(t)).as_matrix(), position


def log_payload(seconds: float = 20.0, rate_hz: float = 250.0, late_s: float = 0.0, noise: float = 0.0, seed: int = 1) -> PayloadLog:
    """Poses at t, and what was felt `late_s` before; noise in N on the force, a twentieth of it in N m on the torque."""
    t = np.arange(0.0, seconds, 1.0 / rate_hz)
    step = 1e-3

    def mass_at(when: Array) -> Array:
        R, p = pose_at(when)
        return p + R @ LEVER_M

    felt = t - late_s
    acceleration = (mass_at(felt + step) - 2.0 * mass_at(felt) + mass_at(felt - step)) / step**2
    force = MASS_KG * np.einsum("nji,nj->ni", pose_at(felt)[0], acceleration + UP)
    offset = np.array([0.4, -0.2, 0.7, 0.01, 0.02, -0.03])
    wrench = np.hstack([force, np.cross(LEVER_M, force)]) + offset
    wrench += np.random.default_rng(seed).normal(scale=[noise] * 3 + [noise / 20.0] * 3, size=wrench.shape)
    return PayloadLog(t, *pose_at(t), wrench)
