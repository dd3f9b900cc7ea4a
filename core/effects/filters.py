"""Causal operators on sampled channels: delay, low-pass, time derivative, play. Compiled.

Before the first row of a run a signal was constant. A run may come in blocks of rows: each operator leaves in its `past` what the
next block needs.
"""

from __future__ import annotations

import math
from typing import Any, cast

import numba
import numpy as np
from numpy.typing import NDArray

from core.effects.memory import Past

Array = NDArray[np.float64]

BACKWARD = np.array([11 / 6, -3.0, 3 / 2, -1 / 3])
"""Derivative at the newest of four samples, third order in the period."""


def delayed(w: Array, samples: float, past: Past | None = None) -> Array:
    """`w` (N, n) late by a number of samples >= 0, whole or not: cubic (Lagrange) through four rows, none newer than the row itself."""
    whole = (past or Past()).before(np.ascontiguousarray(w), math.ceil(samples) + 3)
    return cast(Array, _delayed(whole, float(samples), len(whole) - len(w)))


def low_passed(w: Array, time_constant: complex, period: float, past: Past | None = None) -> Array:
    """`w` (N, n) behind `1 / (1 + T s)`, exact for a signal that is straight between samples.

    Args:
        time_constant: T, in the unit of `period`; complex for one of a pair of poles, and the result is then complex.
    """
    if abs(time_constant) < 1e-9 * period:
        return w.copy()
    T = time_constant
    a = np.exp(-period / T)
    b = T / period * (1 - a)
    past = past or Past()
    whole, first = w, w[0]
    if past.rows is not None:  # the last input and the last output
        whole, first = np.concatenate([past.rows[:1], w]), past.rows[1]
    out = _recursion(np.ascontiguousarray(whole), first, a, b - a, 1 - b)[-len(w) :]
    past.rows = np.stack([w[-1], out[-1]])
    return cast(Array, out)


def derivative(w: Array, period: float, past: Past | None = None) -> Array:
    """Time derivative of `w` (N, n) from each row and the three before it; zero before the start."""
    n = len(w)
    whole = (past or Past()).before(w, 3)
    whole = np.concatenate([np.repeat(whole[:1], n + 3 - len(whole), axis=0), whole])
    return cast(Array, sum(c * whole[3 - j : 3 - j + n] for j, c in enumerate(BACKWARD)) / period)


def play(w: Array, radius: Array, past: Past | None = None) -> Array:
    """Play (backlash) operator: each channel of the result moves only when `w` pushes it, at most `radius` (n,) behind; starts at `w`."""
    past = past or Past()
    start = w[0] if past.rows is None else past.rows[0]
    out = _play(np.ascontiguousarray(w), np.asarray(radius, dtype=float), start)
    past.rows = out[-1:].copy()
    return cast(Array, out)


@numba.njit(cache=True)
def _delayed(w: Array, samples: float, begin: int) -> Array:
    N, n = w.shape
    out = np.empty((N - begin, n))
    for k in range(begin, N):
        p = k - samples
        base = min(int(np.floor(p)) - 1, k - 3)
        x = p - base
        c0 = -(x - 1) * (x - 2) * (x - 3) / 6
        c1 = x * (x - 2) * (x - 3) / 2
        c2 = -x * (x - 1) * (x - 3) / 2
        c3 = x * (x - 1) * (x - 2) / 6
        i0, i1, i2, i3 = max(base, 0), max(base + 1, 0), max(base + 2, 0), max(base + 3, 0)
        for j in range(n):
            out[k - begin, j] = c0 * w[i0, j] + c1 * w[i1, j] + c2 * w[i2, j] + c3 * w[i3, j]
    return out


@numba.njit(cache=True)
def _recursion(w: Array, first: Array, a: complex, before: complex, now: complex) -> NDArray[Any]:
    N, n = w.shape
    out = w * a  # complex where a is
    for j in range(n):
        out[0, j] = first[j]
    for k in range(1, N):
        for j in range(n):
            out[k, j] = a * out[k - 1, j] + before * w[k - 1, j] + now * w[k, j]
    return out


@numba.njit(cache=True)
def _play(w: Array, radius: Array, start: Array) -> Array:
    N, n = w.shape
    out = np.empty_like(w)
    y = start.copy()
    for k in range(N):
        for j in range(n):
            y[j] = max(w[k, j] - radius[j], min(w[k, j] + radius[j], y[j]))
            out[k, j] = y[j]
    return out
