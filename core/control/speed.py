"""Cartesian speed of the robot's points, compiled: the corners of every link's box and of the payload box."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.robot.chain import joint_frames


@njit(cache=True)
def fastest_point(placements: Array, axes: Array, joint: NDArray[np.int64], local: Array, q: Array, dq: Array) -> tuple[float, int]:
    """Speed of the fastest of some points, m/s, and its number, at joint positions q (n,), rad, and velocities dq (n,), rad/s.

    The speed of a rigid body is a convex function of the point, so no point of the boxes is faster than the fastest corner.

    Args:
        placements, axes: of a `Chain`.
        joint, local: of the points, see `SpeedPoints`: (P,), and (P, 3) in the joint's frame, m.
    """
    n = len(q)
    R, p = np.empty((n + 1, 3, 3)), np.empty((n + 1, 3))
    joint_frames(placements, axes, q, R, p)
    w, v = np.empty((n, 3)), np.empty((n, 3))  # angular velocity of each link, velocity of its joint's origin
    for j in range(n):
        for r in range(3):
            w[j, r] = (R[j, r, 0] * axes[j, 0] + R[j, r, 1] * axes[j, 1] + R[j, r, 2] * axes[j, 2]) * dq[j]
            v[j, r] = 0.0
        if j > 0:
            dx, dy, dz = p[j, 0] - p[j - 1, 0], p[j, 1] - p[j - 1, 1], p[j, 2] - p[j - 1, 2]
            wx, wy, wz = w[j - 1]
            v[j, 0] = v[j - 1, 0] + wy * dz - wz * dy
            v[j, 1] = v[j - 1, 1] + wz * dx - wx * dz
            v[j, 2] = v[j - 1, 2] + wx * dy - wy * dx
            for r in range(3):
                w[j, r] += w[j - 1, r]
    fastest, index = -1.0, 0
    for k in range(len(joint)):
        j = joint[k]
        a, b, c = local[k]
        x = R[j, 0, 0] * a + R[j, 0, 1] * b + R[j, 0, 2] * c
        y = R[j, 1, 0] * a + R[j, 1, 1] * b + R[j, 1, 2] * c
        z = R[j, 2, 0] * a + R[j, 2, 1] * b + R[j, 2, 2] * c
        vx = v[j, 0] + w[j, 1] * z - w[j, 2] * y
        vy = v[j, 1] + w[j, 2] * x - w[j, 0] * z
        vz = v[j, 2] + w[j, 0] * y - w[j, 1] * x
        square = vx * vx + vy * vy + vz * vz
        if square > fastest:
            fastest, index = square, k
    return np.sqrt(fastest), index
