"""Eq. (1), compiled: the wrench of a rigid payload, evaluated many thousand times over while effects are fitted.

`core.payload.inertia.regressor` says the same as a matrix; this stands apart from it so that whoever only needs parameters waits for no
compiler.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.payload.inertia import Motion


def wrench(motion: Motion, phi: Array) -> Array:
    """Force and torque (N, 6) that the sensor exerts on the payload, Eq. (1); equals `regressor(motion) @ phi`."""
    return np.asarray(_wrench(motion.g, motion.a, motion.omega, motion.alpha, np.ascontiguousarray(phi, dtype=float)))


@njit(cache=True)
def _wrench(g: Array, a: Array, omega: Array, alpha: Array, phi: Array) -> Array:
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
