"""The largest share of a task that any joint velocities within bounds achieve: a linear program, solved by a small
simplex.

Algorithm 7 never gives a saturated joint back, and so loses some scale now and then (several per cent in about one of a
hundred hard cases; far more where acceleration limits keep 0 out of the bounds). Where it scales, the exact answer is
worth a few microseconds more.

    largest s   subject to   J dq = s x,   lower <= dq <= upper,   0 <= s <= 1

Two phases, bounded variables, the condensed tableau (columns of the nonbasic variables only matter; an artificial
variable that has left the basis never returns). scipy's `linprog` is the oracle in the tests.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array

_TOLERANCE = 1e-10
_PIVOTS = 100


@njit(cache=True)
def _find_entering_column(T: Array, basis: NDArray[np.int64], at_upper: NDArray[np.bool_], n: int) -> int:
    """Phase 1: the column that most lowers the sum of the artificials (basis > n), -1 at the optimum."""
    m = len(basis)
    best, column = _TOLERANCE, -1
    for j in range(n + 1):
        gain = 0.0
        basic = False
        for i in range(m):
            basic = basic or basis[i] == j
            if basis[i] > n:
                gain += T[i, j]
        if basic:
            continue
        gain = -gain if at_upper[j] else gain
        if gain > best:
            best, column = gain, j
    return column


@njit(cache=True)
def _find_raising_column(T: Array, basis: NDArray[np.int64], at_upper: NDArray[np.bool_], n: int) -> int:
    """Phase 2: the column that most raises s (column n), -1 at the optimum."""
    m = len(basis)
    row = -1
    for i in range(m):
        if basis[i] == n:
            row = i
    if row < 0:
        return -1 if at_upper[n] else n
    best, column = _TOLERANCE, -1
    for j in range(n):
        basic = False
        for i in range(m):
            basic = basic or basis[i] == j
        gain = T[row, j] if at_upper[j] else -T[row, j]
        if not basic and gain > best:
            best, column = gain, j
    return column


@njit(cache=True)
def _exchange(T: Array, value: Array, width: Array, basis: NDArray[np.int64], at_upper: NDArray[np.bool_], j: int, phase: int) -> None:
    """Moves column j off its bound as far as the others allow: to its other bound, or into the basis in exchange for what blocks."""
    m, n = len(basis), T.shape[1] - 1
    sign = -1.0 if at_upper[j] else 1.0
    step, row, to_upper = width[j], -1, False
    for i in range(m):
        rate = -sign * T[i, j]  # of the basic variable
        if rate < -_TOLERANCE:
            room, up = value[i] / -rate, False
        elif rate > _TOLERANCE and (basis[i] <= n or phase == 2):
            room, up = ((width[basis[i]] if basis[i] <= n else 0.0) - value[i]) / rate, True
        else:
            continue
        if room < step:
            step, row, to_upper = max(room, 0.0), i, up
    for i in range(m):
        value[i] -= sign * T[i, j] * step
    if row < 0:
        at_upper[j] = not at_upper[j]
        return
    if basis[row] <= n:
        at_upper[basis[row]] = to_upper
    value[row] = (width[j] if at_upper[j] else 0.0) + sign * step
    basis[row] = j
    at_upper[j] = False
    pivot = T[row, j]
    for c in range(n + 1):
        T[row, c] /= pivot
    for i in range(m):
        if i != row:
            factor = T[i, j]
            for c in range(n + 1):
                T[i, c] -= factor * T[row, c]


@njit(cache=True)
def _largest_scale(J: Array, x: Array, lower: Array, upper: Array, dq: Array) -> float:  # noqa: PLR0912 - compiled: loops instead of array expressions
    """Fills dq (n,) and returns s; -1 where no s in [0, 1] can be had within the bounds."""
    m, n = J.shape
    T = np.empty((m, n + 1))
    value = np.empty(m)
    width = np.empty(n + 1)
    basis = np.empty(m, np.int64)
    at_upper = np.zeros(n + 1, np.bool_)
    for j in range(n):
        width[j] = upper[j] - lower[j]
    width[n] = 1.0
    size = 0.0
    for i in range(m):
        value[i] = 0.0
        for j in range(n):
            value[i] -= J[i, j] * lower[j]
        sign = -1.0 if value[i] < 0.0 else 1.0
        value[i] *= sign
        size = max(size, value[i])
        for j in range(n):
            T[i, j] = sign * J[i, j]
        T[i, n] = -sign * x[i]
        basis[i] = n + 1 + i
    for phase in (1, 2):
        for _ in range(_PIVOTS):
            j = _find_entering_column(T, basis, at_upper, n) if phase == 1 else _find_raising_column(T, basis, at_upper, n)
            if j < 0:
                break
            _exchange(T, value, width, basis, at_upper, j, phase)
        for i in range(m):
            if basis[i] > n and value[i] > 1e-9 * (1.0 + size):
                return -1.0
    s = 1.0 if at_upper[n] else 0.0
    for j in range(n):
        dq[j] = upper[j] if at_upper[j] else lower[j]
    for i in range(m):
        if basis[i] == n:
            s = value[i]
        elif basis[i] < n:
            dq[basis[i]] = lower[basis[i]] + value[i]
    for j in range(n):
        dq[j] = min(max(dq[j], lower[j]), upper[j])
    return min(max(s, 0.0), 1.0)
