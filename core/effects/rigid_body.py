"""Eq. (1) for a rigid payload, compiled: what the effects on motion and payload evaluate hundreds of times per fit."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.effects.scene import Scene
from core.inertia import Motion

Array = NDArray[np.float64]


@njit(cache=True)
def _rigid_wrench(g: Array, a: Array, omega: Array, alpha: Array, phi: Array) -> Array:
    N = len(g)
    w = np.empty((N, 6))
    m, cx, cy, cz = phi[0], phi[1], phi[2], phi[3]
    Ixx, Ixy, Ixz, Iyy, Iyz, Izz = phi[4], phi[5], phi[6], phi[7], phi[8], phi[9]
    for k in range(N):
        bx, by, bz = a[k, 0] - g[k, 0], a[k, 1] - g[k, 1], a[k, 2] - g[k, 2]
        px, py, pz = omega[k, 0], omega[k, 1], omega[k, 2]
        ax, ay, az = alpha[k, 0], alpha[k, 1], alpha[k, 2]
        sx, sy, sz = py * cz - pz * cy, pz * cx - px * cz, px * cy - py * cx
        w[k, 0] = m * bx + ay * cz - az * cy + py * sz - pz * sy
        w[k, 1] = m * by + az * cx - ax * cz + pz * sx - px * sz
        w[k, 2] = m * bz + ax * cy - ay * cx + px * sy - py * sx
        hx, hy, hz = Ixx * px + Ixy * py + Ixz * pz, Ixy * px + Iyy * py + Iyz * pz, Ixz * px + Iyz * py + Izz * pz
        w[k, 3] = cy * bz - cz * by + Ixx * ax + Ixy * ay + Ixz * az + py * hz - pz * hy
        w[k, 4] = cz * bx - cx * bz + Ixy * ax + Iyy * ay + Iyz * az + pz * hx - px * hz
        w[k, 5] = cx * by - cy * bx + Ixz * ax + Iyz * ay + Izz * az + px * hy - py * hx
    return w


def rigid_wrench(motion: Motion, phi: Array) -> Array:
    """(N, 6), the same as `core.inertia.wrench`, without the regressor."""
    return np.asarray(_rigid_wrench(motion.g, motion.a, motion.omega, motion.alpha, np.ascontiguousarray(phi, dtype=float)))


def wrench_change(scene: Scene, true: Motion) -> Array:
    """(N, 6), what the scene's payload asks more of the sensor under the true motion than under the nominal one."""
    return rigid_wrench(true, scene.phi) - rigid_wrench(scene.motion, scene.phi)


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
