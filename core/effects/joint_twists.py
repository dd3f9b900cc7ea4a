"""What each joint does to the sensor's twist along a run, compiled: the same for all that is fitted to the run."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from core.array import Array


class JointTwists(NamedTuple):
    """Along N rows with n joints.

    Args:
        changes: (N, n, 6), of the sensor's twist per radian of each joint's error, `-ad(J_j) V_<j`: only what comes from before the joint
            is seen from turned axes.
        velocity: (N, 3), of the sensor's origin in sensor axes, m/s.
    """

    changes: Array
    velocity: Array


def find_joint_twists(jacobian: Array, dq: Array) -> JointTwists:
    """From the Jacobian (N, 6, n), linear over angular in sensor axes, and velocities (N, n), rad/s."""
    return JointTwists(*_find(jacobian, dq))


@njit(cache=True)
def _find(J: Array, dq: Array) -> tuple[Array, Array]:
    N, n = dq.shape
    E, velocity = np.empty((N, n, 6)), np.empty((N, 3))
    for k in range(N):
        vx = vy = vz = wx = wy = wz = 0.0
        for j in range(n):
            ax, ay, az, bx, by, bz = J[k, 0, j], J[k, 1, j], J[k, 2, j], J[k, 3, j], J[k, 4, j], J[k, 5, j]
            E[k, j, 0] = bz * vy - by * vz + az * wy - ay * wz
            E[k, j, 1] = bx * vz - bz * vx + ax * wz - az * wx
            E[k, j, 2] = by * vx - bx * vy + ay * wx - ax * wy
            E[k, j, 3] = bz * wy - by * wz
            E[k, j, 4] = bx * wz - bz * wx
            E[k, j, 5] = by * wx - bx * wy
            s = dq[k, j]
            vx += ax * s
            vy += ay * s
            vz += az * s
            wx += bx * s
            wy += by * s
            wz += bz * s
        velocity[k, 0], velocity[k, 1], velocity[k, 2] = vx, vy, vz
    return E, velocity
