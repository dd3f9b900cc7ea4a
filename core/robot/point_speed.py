"""Positions and speeds of the corners of links and payload box, for many configurations at once, compiled."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.robot.bodies import SpeedPoints
from core.robot.chain import Chain, joint_frames


@njit(cache=True)
def _positions(placements: Array, axes: Array, joint: NDArray[np.int64], local: Array, q: Array) -> Array:
    n = q.shape[1]
    R = np.empty((n + 1, 3, 3))
    p = np.empty((n + 1, 3))
    out = np.empty((len(q), len(joint), 3))
    for k in range(len(q)):
        joint_frames(placements, axes, q[k], R, p)
        for i in range(len(joint)):
            j = joint[i]
            for r in range(3):
                out[k, i, r] = p[j, r] + R[j, r, 0] * local[i, 0] + R[j, r, 1] * local[i, 1] + R[j, r, 2] * local[i, 2]
    return out


@njit(cache=True)
def _speeds(placements: Array, axes: Array, joint: NDArray[np.int64], local: Array, q: Array, dq: Array) -> Array:
    n = q.shape[1]
    R = np.empty((n + 1, 3, 3))
    p = np.empty((n + 1, 3))
    omega = np.zeros((n, 3))  # angular velocity of each joint's frame
    drift = np.zeros((n, 3))  # velocity of the material point of that body at the world's origin
    out = np.empty((len(q), len(joint)))
    for k in range(len(q)):
        joint_frames(placements, axes, q[k], R, p)
        wx = wy = wz = vx = vy = vz = 0.0
        for j in range(n):
            ax = (R[j, 0, 0] * axes[j, 0] + R[j, 0, 1] * axes[j, 1] + R[j, 0, 2] * axes[j, 2]) * dq[k, j]
            ay = (R[j, 1, 0] * axes[j, 0] + R[j, 1, 1] * axes[j, 1] + R[j, 1, 2] * axes[j, 2]) * dq[k, j]
            az = (R[j, 2, 0] * axes[j, 0] + R[j, 2, 1] * axes[j, 1] + R[j, 2, 2] * axes[j, 2]) * dq[k, j]
            wx, wy, wz = wx + ax, wy + ay, wz + az
            vx += p[j, 1] * az - p[j, 2] * ay
            vy += p[j, 2] * ax - p[j, 0] * az
            vz += p[j, 0] * ay - p[j, 1] * ax
            omega[j, 0], omega[j, 1], omega[j, 2] = wx, wy, wz
            drift[j, 0], drift[j, 1], drift[j, 2] = vx, vy, vz
        for i in range(len(joint)):
            j = joint[i]
            x = p[j, 0] + R[j, 0, 0] * local[i, 0] + R[j, 0, 1] * local[i, 1] + R[j, 0, 2] * local[i, 2]
            y = p[j, 1] + R[j, 1, 0] * local[i, 0] + R[j, 1, 1] * local[i, 1] + R[j, 1, 2] * local[i, 2]
            z = p[j, 2] + R[j, 2, 0] * local[i, 0] + R[j, 2, 1] * local[i, 1] + R[j, 2, 2] * local[i, 2]
            sx = drift[j, 0] + omega[j, 1] * z - omega[j, 2] * y
            sy = drift[j, 1] + omega[j, 2] * x - omega[j, 0] * z
            sz = drift[j, 2] + omega[j, 0] * y - omega[j, 1] * x
            out[k, i] = np.sqrt(sx * sx + sy * sy + sz * sz)
    return out


def point_positions(chain: Chain, points: SpeedPoints, q: Array) -> Array:
    """(N, n_points, 3) positions in the world at every row of q (N, n), m."""
    rows = np.ascontiguousarray(q, dtype=float)
    return np.asarray(_positions(chain.placements, chain.axes, points.joint, points.local, rows))


def point_speeds(chain: Chain, points: SpeedPoints, q: Array, dq: Array) -> Array:
    """(N, n_points) speeds |J_p(q) dq| for every row of q and dq (N, n), m/s (or m per path parameter)."""
    rows, rates = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(dq, dtype=float)
    return np.asarray(_speeds(chain.placements, chain.axes, points.joint, points.local, rows, rates))
