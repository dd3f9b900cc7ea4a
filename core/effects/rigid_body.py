"""Rigid-body pieces that the effects on motion and payload share."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.payload.rigid_wrench import wrench as rigid_wrench

Array = NDArray[np.float64]


def wrench_change(scene: Scene, true: Motion) -> Array:
    """(N, 6), what the scene's payload asks more of the sensor under the true motion than under the nominal one."""
    return rigid_wrench(true, scene.phi) - scene.nominal


def cross(u: Array, v: Array) -> Array:
    """Cross product along the last axis, broadcast; `numpy.cross` takes five times as long."""
    x = u[..., 1] * v[..., 2] - u[..., 2] * v[..., 1]
    y = u[..., 2] * v[..., 0] - u[..., 0] * v[..., 2]
    z = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.stack((x, y, z), axis=-1)


def rotation(vector: Array) -> Array:
    """(3, 3) matrix of a rotation vector (3,), Rodrigues' formula; smooth at zero."""
    angle = np.linalg.norm(vector)
    K = np.array([[0.0, -vector[2], vector[1]], [vector[2], 0.0, -vector[0]], [-vector[1], vector[0], 0.0]])
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * K + 0.5 * np.sinc(0.5 * angle / np.pi) ** 2 * (K @ K))


def centre_of_mass(scene: Scene) -> Array:
    """(3,), of the scene's payload, m; the sensor origin where there is no mass to speak of (a trial step of a fit)."""
    m = scene.phi[0]
    return np.asarray(scene.phi[1:4] / m) if m > 0.01 else np.zeros(3)
