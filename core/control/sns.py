"""Saturation in the Null Space, Algorithms 7 and 8, as the paper has them (its slips corrected), in numpy.

Joint velocities for a Cartesian velocity, within bounds: the solution of least norm where it fits; else the most
critical joint is put on its bound and the others take over its share; when too few joints are left, the task is scaled.
This version is the oracle of the compiled one in `sns_kernel`, which the robot runs.

Corrections: W starts as I; the loop goes on while a joint is outside its bounds; the rank is compared with the task's
dimension; Algorithm 8's S_min and S_max are exchanged; a joint with a_i = 0 does not bound s unless b_i is itself
outside, then s = 0; s <= 1. The bounds need not contain 0 here (acceleration limits), so the critical joint is one that
is outside at s = 1 in any case: the one of the least S_max if that is below 1, else the one of the largest S_min.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.array import Array

RANK_TOLERANCE = 1e-5
"""Smallest singular value, relative to the largest, that still counts."""

TOLERANCE = 1e-9
"""Bounds count as kept within this, rad/s; the result is clipped onto them."""


class JointVelocities(NamedTuple):
    """What SNS returns: joint velocities (n,), rad/s, and the share of the task that they achieve, in [0, 1]."""

    dq: Array
    scale: float


def scale_and_critical_joint(a: Array, b: Array, lower: Array, upper: Array) -> tuple[float, int]:
    """Algorithm 8: largest s with `lower <= s a + b <= upper` (0 if there is none in [0, 1]), and the joint that is
    most in the way.

    Args:
        a: (n,) part of the joint velocities that scales with the task; b: (n,) the rest.
        lower, upper: (n,) bounds.
    """
    S_min, S_max = np.full(len(a), -np.inf), np.full(len(a), np.inf)
    moving = np.abs(a) > TOLERANCE * 1e-3
    at_lower, at_upper = (lower - b)[moving] / a[moving], (upper - b)[moving] / a[moving]
    S_min[moving], S_max[moving] = np.minimum(at_lower, at_upper), np.maximum(at_lower, at_upper)
    outside = ~moving & ((b < lower - TOLERANCE) | (b > upper + TOLERANCE))
    if outside.any():
        return 0.0, int(np.argmax(outside))
    s_max, s_min = S_max.min(), S_min.max()
    j_c = int(np.argmin(S_max)) if s_max < 1.0 else int(np.argmax(S_min))
    if s_min > s_max or s_max < 0.0 or s_min > 1.0:
        return 0.0, j_c
    return min(float(s_max), 1.0), j_c


def sns_reference(J: Array, x: Array, lower: Array, upper: Array) -> JointVelocities:
    """Algorithm 7.

    Args:
        J: (m, n) task Jacobian, n >= m.
        x: (m,) task velocity.
        lower, upper: (n,) bounds on the joint velocities, `lower <= upper`.

    Returns:
        Velocities within the bounds with `J dq = scale x`. Where no scale in (0, 1] is found, scale is 0 and each joint
        gets the velocity nearest to 0 that its bounds allow, which brakes it; the task is then not followed.
    """
    m, n = J.shape
    W, dq_N = np.eye(n), np.zeros(n)
    s_best, W_best, dq_N_best = 0.0, W, dq_N
    while np.linalg.matrix_rank(J @ W, rtol=RANK_TOLERANCE) == m:
        JW = W @ np.linalg.pinv(J @ W)  # W again: rounding leaves something in the rows of saturated joints
        dq = dq_N + JW @ (x - J @ dq_N)
        if ((dq >= lower - TOLERANCE) & (dq <= upper + TOLERANCE)).all():
            return JointVelocities(np.clip(dq, lower, upper), 1.0)
        a = JW @ x
        s, j_c = scale_and_critical_joint(a, dq - a, lower, upper)
        if s > s_best:
            s_best, W_best, dq_N_best = s, W.copy(), dq_N.copy()
        W[j_c, j_c] = 0.0
        dq_N[j_c] = upper[j_c] if dq[j_c] > upper[j_c] else lower[j_c]
    if s_best == 0.0:
        return JointVelocities(np.clip(np.zeros(n), lower, upper), 0.0)
    dq = dq_N_best + W_best @ np.linalg.pinv(J @ W_best) @ (s_best * x - J @ dq_N_best)
    return JointVelocities(np.clip(dq, lower, upper), s_best)
