"""Inverse kinematics of any chain of hinges: damped least squares with Sugihara's error-dependent damping, compiled.

T. Sugihara, Solvability-Unconcerned Inverse Kinematics by the Levenberg-Marquardt Method, IEEE Trans. Robotics 27(5), 2011.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.robot.chain import Chain, fill_jacobian, joint_frames
from core.robot.rotations import pose_error

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
            pose_error(R[n], p[n], rotations[i], positions[i], e)
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
            fill_jacobian(R, p, axes, J)
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
