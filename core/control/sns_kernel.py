"""Saturation in the Null Space, compiled: Algorithms 7 and 8 with a Cholesky factorisation of `J W J^T` instead of the
pseudoinverse.

`sns` agrees with `sns.sns_reference` wherever that one does not scale the task; where it does, `largest_scale` takes
over. `sns_step`
is the whole step of the control loop: Jacobian, bounds of Eq. (7), SNS.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.control.bounds import JointLimits, _velocity_bounds
from core.control.largest_scale import _largest_scale
from core.control.sns import RANK_TOLERANCE, TOLERANCE, JointVelocities
from core.robot.chain import Chain, _jacobian

_PIVOT = RANK_TOLERANCE**2  # J W J^T squares the singular values
_ACHIEVED = 1e-7
"""Of 1 and the task's size: what rounding may leave between J dq and the task. Without pivoting a small pivot can hide a lost rank."""


@njit(cache=True)
def _solve_free(J: Array, free: NDArray[np.bool_], L: Array, y: Array) -> bool:  # noqa: PLR0912 - compiled: loops instead of array expressions
    """Solves `J W J^T Y = y` in place for both columns of y (m, 2); False where the rank is less than m."""
    m, n = J.shape
    largest = 0.0
    for r in range(m):
        for c in range(r + 1):
            total = 0.0
            for j in range(n):
                if free[j]:
                    total += J[r, j] * J[c, j]
            L[r, c] = total
        largest = max(largest, L[r, r])
    for c in range(m):
        pivot = L[c, c]
        for k in range(c):
            pivot -= L[c, k] * L[c, k]
        if not pivot > _PIVOT * largest:
            return False
        pivot = np.sqrt(pivot)
        L[c, c] = pivot
        for r in range(c + 1, m):
            total = L[r, c]
            for k in range(c):
                total -= L[r, k] * L[c, k]
            L[r, c] = total / pivot
    for side in range(2):
        for r in range(m):
            total = y[r, side]
            for k in range(r):
                total -= L[r, k] * y[k, side]
            y[r, side] = total / L[r, r]
        for r in range(m - 1, -1, -1):
            total = y[r, side]
            for k in range(r + 1, m):
                total -= L[k, r] * y[k, side]
            y[r, side] = total / L[r, r]
    return True


@njit(cache=True)
def _critical_joint(a: Array, b: Array, lower: Array, upper: Array) -> int:
    """Algorithm 8, without the scale, which `largest_scale` finds."""
    s_max, s_min = np.inf, -np.inf
    j_max, j_min = 0, 0
    for i in range(len(a)):
        if abs(a[i]) <= TOLERANCE * 1e-3:
            if b[i] < lower[i] - TOLERANCE or b[i] > upper[i] + TOLERANCE:
                return i
            continue
        S_min, S_max = (lower[i] - b[i]) / a[i], (upper[i] - b[i]) / a[i]
        if S_min > S_max:
            S_min, S_max = S_max, S_min
        if S_max < s_max:
            s_max, j_max = S_max, i
        if S_min > s_min:
            s_min, j_min = S_min, i
    return j_max if s_max < 1.0 else j_min


@njit(cache=True)
def _achieves(J: Array, dq: Array, x: Array, s: float) -> bool:
    """Whether `J dq = s x` but for rounding."""
    size = np.abs(x).max()
    for r in range(len(x)):
        missing = s * x[r]
        for j in range(len(dq)):
            missing -= J[r, j] * dq[j]
        if not abs(missing) <= _ACHIEVED * (1.0 + size):
            return False
    return True


@njit(cache=True)
def _sns(J: Array, x: Array, lower: Array, upper: Array, dq: Array) -> float:
    """Algorithm 7; fills dq (n,) and returns the scale."""
    m, n = J.shape
    free = np.ones(n, np.bool_)
    dq_N, a, b = np.zeros(n), np.empty(n), np.empty(n)
    L, y = np.empty((m, m)), np.empty((m, 2))
    for _ in range(n + 1):
        for r in range(m):
            y[r, 0] = y[r, 1] = x[r]
            for j in range(n):
                y[r, 0] -= J[r, j] * dq_N[j]
        if not _solve_free(J, free, L, y):
            break
        outside = False
        for j in range(n):
            dq[j], a[j] = dq_N[j], 0.0
            if free[j]:
                for r in range(m):
                    dq[j] += J[r, j] * y[r, 0]
                    a[j] += J[r, j] * y[r, 1]
            b[j] = dq[j] - a[j]
            outside = outside or dq[j] < lower[j] - TOLERANCE or dq[j] > upper[j] + TOLERANCE
        if not outside:
            for j in range(n):
                dq[j] = min(max(dq[j], lower[j]), upper[j])
            if _achieves(J, dq, x, 1.0):
                return 1.0
            break
        j_c = _critical_joint(a, b, lower, upper)
        free[j_c] = False
        dq_N[j_c] = upper[j_c] if dq[j_c] > upper[j_c] else lower[j_c]
    s = _largest_scale(J, x, lower, upper, dq)
    if s <= 0.0 or not _achieves(J, dq, x, s):
        for j in range(n):
            dq[j] = min(max(0.0, lower[j]), upper[j])
        return 0.0
    return float(s)


@njit(cache=True)
def _brake(dq: Array, lower: Array, upper: Array, out: Array) -> None:
    """All joints in proportion, as hard as the first of them allows: the robot stays on its path while it brakes."""
    share = 0.0
    for i in range(len(dq)):
        if abs(dq[i]) > 1e-12:
            share = max(share, (lower[i] if dq[i] > 0.0 else upper[i]) / dq[i])
    for i in range(len(dq)):
        out[i] = min(max(share * dq[i], lower[i]), upper[i])


@njit(cache=True)
def _sns_step(
    J: Array,
    q: Array,
    dq: Array,
    x: Array,
    lower: Array,
    upper: Array,
    velocity: Array,
    acceleration: Array,
    T: float,
    out: Array,
) -> float:
    n = len(q)
    lo, hi = np.empty(n), np.empty(n)
    _velocity_bounds(q, dq, lower, upper, velocity, acceleration, T, lo, hi)
    s = _sns(J[6 - len(x) :], x, lo, hi, out)
    if s == 0.0:
        _brake(dq, lo, hi, out)
    return float(s)


def sns(J: Array, x: Array, lower: Array, upper: Array) -> JointVelocities:
    """As `sns.sns_reference`, but the scale is the largest that is possible, up to rounding.

    Args:
        J: (m, n) task Jacobian, n >= m.
        x: (m,) task velocity.
        lower, upper: (n,) bounds on the joint velocities, `lower <= upper`.
    """
    dq = np.empty(J.shape[1])
    s = _sns(np.ascontiguousarray(J), x, lower, upper, dq)
    return JointVelocities(dq, s)


def sns_step(chain: Chain, q: Array, dq: Array, x: Array, limits: JointLimits, period: float) -> JointVelocities:
    """Joint velocities of the next period for a task velocity of the sensor frame: Jacobian, Eq. (7), Algorithms 7 and
    8.

    Args:
        chain: the robot's.
        q: (n,) joint positions now, rad; dq: (n,) joint velocities of the period that ends now, rad/s.
        x: (6,) linear velocity of the sensor origin, then angular velocity, both in sensor axes; (3,) angular velocity
            alone.
        limits: of the joints.
        period: T_s, s.

    Returns:
        As `sns`; where no share of the task is possible, velocities that brake.
    """
    out = np.empty(len(q))
    s = _sns_step(_jacobian(chain.placements, chain.axes, q), q, dq, x, *limits, period, out)
    return JointVelocities(out, s)
