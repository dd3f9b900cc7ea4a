"""The grid of time that everything is computed on, and what signals go through: derivatives, lags, laws with memory, slow wander."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy import signal
from scipy.ndimage import gaussian_filter1d

from bench.stranger.array import Array

STEP_S = 1e-3
"""Of the grid, s."""
PAD = 1500
"""Steps that the arm stands still before the recording begins and after it ends."""


def list_times(count: int) -> Array:
    """(count,), s; the recording begins at zero."""
    return np.asarray((np.arange(count) - PAD) * STEP_S)


def derive(x: Array) -> Array:
    """The derivative by time of a signal (N, ...) on the grid, per s."""
    return np.asarray(np.gradient(x, STEP_S, axis=0))


def lag_once(x: Array, tau_s: float) -> Array:
    """A signal (N, ...) behind a first-order lag, at rest in the beginning."""
    share = STEP_S / (tau_s + STEP_S)
    return np.asarray(signal.lfilter([share], [1, share - 1], x, axis=0, zi=(1 - share) * x[:1])[0])


def lag_twice(x: Array, corner_hz: float) -> Array:
    """A signal (N, ...) behind a critically damped second-order lag, at rest in the beginning."""
    w = 2 * np.pi * corner_hz
    b, a = signal.bilinear([w**2], [1, 2 * w, w**2], fs=1 / STEP_S)
    return filter_from_rest(b, a, x)


def filter_from_rest(b: Array, a: Array, x: Array) -> Array:
    """A signal (N, ...) behind a filter that had seen its first value for ever."""
    zi = signal.lfilter_zi(b, a).reshape(-1, *(1,) * (x.ndim - 1))
    return np.asarray(signal.lfilter(b, a, x, axis=0, zi=zi * x[:1])[0])


def run_coarsely(law: Callable[[Array], Array], x: Array, every: int = 5) -> Array:
    """A law that goes from sample to sample, on every fifth of a signal (N, k), with straight lines between."""
    y = law(x[::every])
    i = np.arange(len(x))
    return np.stack([np.interp(i, i[::every], y[:, c]) for c in range(y.shape[1])], 1)


def draw_wander(rng: np.random.Generator, t: Array, seconds: float, columns: int, smooth_s: float = 0.8) -> Array:
    """(N, columns), random walks with one step of about 1 in a second, smoothed."""
    n = int(seconds) + 3
    y = np.cumsum(rng.normal(size=(n, columns)), 0)
    x = np.linspace(-2, seconds + 2, n)
    return np.stack([gaussian_filter1d(np.interp(t, x, y[:, i]), int(smooth_s / STEP_S)) for i in range(columns)], 1)


def rise_and_fall(t: Array, begin_s: float, end_s: float, rise_s: float = 0.25) -> Array:
    """(N,), 0 to 1 and back as a hand does: lets go more slowly than it takes hold."""
    return rise_softly((t - begin_s) / rise_s) * rise_softly((end_s - t) / (rise_s * 1.6))


def rise_softly(x: Array) -> Array:
    """From 0 to 1 around x = 0, within about one to each side."""
    return np.asarray(1 / (1 + np.exp(-np.clip(x, -40, 40) * 4)))


def step_softly(t: Array, at_s: float, width_s: float) -> Array:
    """(N,), from 0 to 1 around a time; the logistic function of (t - at) / width."""
    return np.asarray(1 / (1 + np.exp(-np.clip((t - at_s) / width_s, -50, 50))))
