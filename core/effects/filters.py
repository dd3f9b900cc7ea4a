"""Causal operators on sampled channels: delay, low-pass, time derivative, play. Compiled; before its first row a signal was constant."""

from __future__ import annotations

from typing import Any, cast

import numba
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BACKWARD = np.array([11 / 6, -3.0, 3 / 2, -1 / 3])
"""Derivative at the newest of four samples, third order in the period."""


def delayed(w: Array, samples: float) -> Array:
    """`w` (N, n) late by a number of samples >= 0, whole or not: cubic (Lagrange) through four rows, none newer than the row itself."""
    return cast(Array, _delayed(np.ascontiguousarray(w), float(samples)))


def low_passed(w: Array, time_constant: complex, period: float) -> Array:
    """`w` (N, n) behind `1 / (1 + T s)`, exact for a signal that is straight between samples.

    Args:
        time_constant: T, in the unit of `period`; complex for one of a pair of poles, and the result is then complex.
    """
    if abs(time_constant) < 1e-9 * period:
        return w.copy()
    T = time_constant
    a = np.exp(-period / T)
    b = T / period * (1 - a)
    return cast(Array, _recursion(np.ascontiguousarray(w), a, b - a, 1 - b))


def derivative(w: Array, period: float) -> Array:
    """Time derivative of `w` (N, n) from each row and the three before it; zero before the start."""
    past = np.concatenate([np.repeat(w[:1], 3, axis=0), w])
    n = len(w)
    return cast(Array, sum(c * past[3 - j : 3 - j + n] for j, c in enumerate(BACKWARD)) / period)


def play(w: Array, radius: Array) -> Array:
    """Play (backlash) operator: each channel of the result moves only when `w` pushes it, at most `radius` (n,) behind; starts at `w`."""
    return cast(Array, _play(np.ascontiguousarray(w), np.asarray(radius, dtype=float)))


@numba.njit(cache=True)
def _delayed(w: Array, samples: float) -> Array:
    N, n = w.shape
    out = np.empty_like(w)
    for k in range(N):
        p = k - samples
        base = min(int(np.floor(p)) - 1, k - 3)
        x = p - base
        c0 = -(x - 1) * (x - 2) * (x - 3) / 6
        c1 = x * (x - 2) * (x - 3) / 2
        c2 = -x * (x - 1) * (x - 3) / 2
        c3 = x * (x - 1) * (x - 2) / 6
        i0, i1, i2, i3 = max(base, 0), max(base + 1, 0), max(base + 2, 0), max(base + 3, 0)
        for j in range(n):
            out[k, j] = c0 * w[i0, j] + c1 * w[i1, j] + c2 * w[i2, j] + c3 * w[i3, j]
    return out


@numba.njit(cache=True)
def _recursion(w: Array, a: complex, before: complex, now: complex) -> NDArray[Any]:
    N, n = w.shape
    out = w * a  # complex where a is
    for j in range(n):
        out[0, j] = w[0, j]
    for k in range(1, N):
        for j in range(n):
            out[k, j] = a * out[k - 1, j] + before * w[k - 1, j] + now * w[k, j]
    return out


@numba.njit(cache=True)
def _play(w: Array, radius: Array) -> Array:
    N, n = w.shape
    out = np.empty_like(w)
    for j in range(n):
        r, y = radius[j], w[0, j]
        for k in range(N):
            y = max(w[k, j] - r, min(w[k, j] + r, y))
            out[k, j] = y
    return out
