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

from core.array import Array
from core.effects.memory import Past

ROWS = 6
"""That a value between samples is interpolated from: with four, what is left of a sharp delay looks like a filter."""
BACKWARD = np.array([11 / 6, -3.0, 3 / 2, -1 / 3])
"""Derivative at the newest of four samples, third order in the period."""


def delay_signal(w: Array, samples: float, past: Past | None = None) -> Array:
    """`w` (N, n) late by a number of samples >= 0, whole or not: quintic (Lagrange) through six rows, none newer than the row itself."""
    newest = max(0, math.floor(samples) - ROWS // 2 + 1)
    lags = newest + np.arange(ROWS)
    weights = np.array([np.prod([(samples - other) / (lag - other) for other in lags if other != lag]) for lag in lags])
    whole = (past or Past()).before(np.ascontiguousarray(w), newest + ROWS)
    return cast(Array, _delay(whole, weights, newest, len(whole) - len(w)))


def delay_each(w: Array, samples: Array) -> Array:
    """`w` (N, n) with each row late by a number of samples of its own (N,), as `delay_signal` has it; before the first row as in it, and
    nothing is early."""
    samples = np.maximum(samples, 0.0)[:, None]
    lags = np.maximum(0.0, np.floor(samples) - ROWS // 2 + 1) + np.arange(ROWS)
    weights = np.ones(lags.shape)
    for i, j in np.ndindex(ROWS, ROWS):
        if i != j:
            weights[:, i] *= (samples[:, 0] - lags[:, j]) / (lags[:, i] - lags[:, j])
    rows = np.maximum(np.arange(len(w))[:, None] - lags.astype(int), 0)
    return np.asarray(np.einsum("ki,kin->kn", weights, w[rows]))


def low_pass(w: Array, time_constant: complex, period: float, past: Past | None = None) -> Array:
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
def _delay(w: Array, weights: Array, newest: int, begin: int) -> Array:
    N, n = w.shape
    out = np.zeros((N - begin, n))
    for k in range(begin, N):
        for i in range(len(weights)):
            row = max(k - newest - i, 0)
            for j in range(n):
                out[k - begin, j] += weights[i] * w[row, j]
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
