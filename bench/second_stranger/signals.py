"""The grid of time that everything is computed on, and what signals go through: derivatives, lags, resonances, smooth steps."""

from __future__ import annotations

import numpy as np
from scipy.signal import lfilter

from bench.second_stranger.array import Array

STEP_S = 1e-3
"""Of the grid, s."""


def derive(x: Array) -> Array:
    """The derivative by time of a signal (N, ...) on the grid, per s."""
    return np.asarray(np.gradient(x, STEP_S, axis=0))


def lag(x: Array, tau_s: float) -> Array:
    """A signal (N, k) behind a first-order lag, at rest in the beginning."""
    a = np.exp(-STEP_S / tau_s)
    return np.asarray(x[:1] + lfilter([1 - a], [1, -a], x - x[:1], axis=0))


def lag_columns(x: Array, taus_s: Array) -> Array:
    """A signal (N, k), each column behind a first-order lag of its own."""
    return np.stack([lag(x[:, i : i + 1], tau)[:, 0] for i, tau in enumerate(taus_s)], 1)


def resonate(x: Array, f_hz: float, damping: float) -> Array:
    """A signal (N, k) behind a second-order system (bilinear), at rest in the beginning; it keeps what is constant."""
    w, k = 2 * np.pi * f_hz, 2 / STEP_S
    D = k * k + 2 * damping * w * k + w * w
    b = np.array([w * w, 2 * w * w, w * w]) / D
    a = np.array([1, (2 * w * w - 2 * k * k) / D, (k * k - 2 * damping * w * k + w * w) / D])
    return np.asarray(x[:1] + lfilter(b, a, x - x[:1], axis=0))


def rise(x: Array) -> Array:
    """From 0 at x = 0 to 1 at x = 1, with two continuous derivatives."""
    x = np.clip(x, 0, 1)
    return np.asarray(x * x * x * (10 - 15 * x + 6 * x * x))


def follow_dahl(steps: Array, width: float) -> Array:
    """(N + 1,), from zero: Dahl's friction between -1 and 1, after steps (N,) of a path, that it needs about `width` of to turn round."""
    z, followed = 0.0, [0.0]
    for d in steps.tolist():
        z += d / width * (1 - z * (1 if d > 0 else -1))
        followed.append(z)
    return np.array(followed)
