"""Inverse kinematics of any chain of hinges: damped least squares with Sugihara's error-dependent damping, compiled.

T. Sugihara, Solvability-Unconcerned Inverse Kinematics by the Levenberg-Marquardt Method, IEEE Trans. Robotics 27(5), 2011.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.robot.chain import Chain, joint_frames

Array = NDArray[np.float64]

TOLERANCE = 1e-7
"""Largest remaining error of a solution, m and rad."""

ITERATIONS = 24
_LONGEST_STEP = 0.6  # rad
_PATIENCE = 6  # iterations after which the error must have halved, again and again


@dataclass(frozen=True)
class Solutions:
    """One attempt per row.

    Args:
        q: (N, n), rad; a solution only where `solved`.
        solved: (N,).
    """

    q: Array
    solved: NDArray[np.bool_]


@njit(cache=True)
def _pose_error(R: Array, p: Array, rotation: Array, position: Array, e: Array) -> None:
    """Fills e (6,) with the way from the pose (R, p) to the wanted one, in the axes of R: translation, then rotation vector."""
    trace = 0.0
    for i in range(3):
        s = 0.0
        for r in range(3):
            s += R[r, i] * (position[r] - p[r])
        e[i] = s
    E = np.empty((3, 3))
    for i in range(3):
        for k in range(3):
            E[i, k] = R[0, i] * rotation[0, k] + R[1, i] * rotation[1, k] + R[2, i] * rotation[2, k]
        trace += E[i, i]
    e[3], e[4], e[5] = 0.5 * (E[2, 1] - E[1, 2]), 0.5 * (E[0, 2] - E[2, 0]), 0.5 * (E[1, 0] - E[0, 1])
    sine = np.sqrt(e[3] * e[3] + e[4] * e[4] + e[5] * e[5])
    if sine > 1e-9:
        factor = np.arctan2(sine, 0.5 * (trace - 1.0)) / sine
        for i in range(3, 6):
            e[i] *= factor


@njit(cache=True)
def _fill_jacobian(R: Array, p: Array, axes: Array, J: Array) -> None:
    """Fills J (6, n): velocity of the sensor in its own axes, linear over angular, from the joints' frames."""
    n = len(axes)
    for j in range(n):
        w0 = R[j, 0, 0] * axes[j, 0] + R[j, 0, 1] * axes[j, 1] + R[j, 0, 2] * axes[j, 2]
        w1 = R[j, 1, 0] * axes[j, 0] + R[j, 1, 1] * axes[j, 1] + R[j, 1, 2] * axes[j, 2]
        w2 = R[j, 2, 0] * axes[j, 0] + R[j, 2, 1] * axes[j, 1] + R[j, 2, 2] * axes[j, 2]
        d0, d1, d2 = p[n, 0] - p[j, 0], p[n, 1] - p[j, 1], p[n, 2] - p[j, 2]
        v0, v1, v2 = w1 * d2 - w2 * d1, w2 * d0 - w0 * d2, w0 * d1 - w1 * d0
        for c in range(3):
            J[c, j] = R[n, 0, c] * v0 + R[n, 1, c] * v1 + R[n, 2, c] * v2
            J[3 + c, j] = R[n, 0, c] * w0 + R[n, 1, c] * w1 + R[n, 2, c] * w2


@njit(cache=True)
def _fill_damped_step(J: Array, e: Array, damping: float, A: Array, y: Array, dq: Array) -> None:
    """dq = J^T (J J^T + damping I)^-1 e by Cholesky; A (6, 6) and y (6,) are room to work in."""
    n = J.shape[1]
    for r in range(6):
        for c in range(r + 1):
            s = damping if r == c else 0.0
            for j in range(n):
                s += J[r, j] * J[c, j]
            for k in range(c):
                s -= A[r, k] * A[c, k]
            if r == c:
                A[r, r] = np.sqrt(max(s, 1e-30))
            else:
                A[r, c] = s / A[c, c]
        s = e[r]
        for k in range(r):
            s -= A[r, k] * y[k]
        y[r] = s / A[r, r]
    for r in range(5, -1, -1):
        s = y[r]
        for k in range(r + 1, 6):
            s -= A[k, r] * y[k]
        y[r] = s / A[r, r]
    for j in range(n):
        s = 0.0
        for r in range(6):
            s += J[r, j] * y[r]
        dq[j] = s


@njit(cache=True)
def _solve(placements: Array, axes: Array, lower: Array, upper: Array, q: Array, rotations: Array, positions: Array) -> NDArray[np.bool_]:
    """Improves every row of q (N, n) in place; returns which rows were solved."""
    count, n = q.shape
    solved = np.zeros(count, dtype=np.bool_)
    R, p = np.empty((n + 1, 3, 3)), np.empty((n + 1, 3))
    J, A = np.empty((6, n)), np.empty((6, 6))
    e, y, dq = np.empty(6), np.empty(6), np.empty(n)
    for i in range(count):
        watched = np.inf
        for iteration in range(ITERATIONS):
            joint_frames(placements, axes, q[i], R, p)
            _pose_error(R[n], p[n], rotations[i], positions[i], e)
            largest, E = 0.0, 0.0
            for r in range(6):
                largest = max(largest, abs(e[r]))
                E += e[r] * e[r]
            if largest < TOLERANCE:
                solved[i] = True
                break
            if iteration % _PATIENCE == 0:
                if 0.25 * watched < E:
                    break
                watched = E
            _fill_jacobian(R, p, axes, J)
            _fill_damped_step(J, e, 0.05 * E + 1e-9, A, y, dq)
            longest = 0.0
            for j in range(n):
                longest = max(longest, abs(dq[j]))
            scale = min(1.0, _LONGEST_STEP / longest)
            for j in range(n):
                q[i, j] = min(max(q[i, j] + scale * dq[j], lower[j]), upper[j])
    return solved


def solve_poses(chain: Chain, lower: Array, upper: Array, starts: Array, rotations: Array, positions: Array) -> Solutions:
    """Joint positions that put the sensor frame at each pose, from one start each.

    Args:
        lower, upper: (n,), joint limits that solutions keep.
        starts: (N, n), within the limits.
        rotations, positions: (N, 3, 3) and (N, 3), wanted sensor frames in the world.
    """
    q = np.array(starts, dtype=float, order="C")
    targets = np.ascontiguousarray(rotations, dtype=float), np.ascontiguousarray(positions, dtype=float)
    return Solutions(q, np.asarray(_solve(chain.placements, chain.axes, lower, upper, q, *targets)))
