"""A damped oscillator driven sample by sample, exact for an input that is linear between samples."""

from __future__ import annotations

import cmath
import math

import numpy as np
from numba import njit

from core.array import Array
from core.effects.memory import Past

LEAST_STIFFNESS = 0.01
"""Share of its own stiffness that the field leaves an oscillator at least: it sags, but does not fall over."""
APART = 1.15
"""Ratio of frequencies within which two peaks belong to one mode."""


@njit(cache=True)
def _run(u: Array, start: Array, A: Array, before: Array, now: Array, out: Array) -> None:
    for c in range(u.shape[1]):
        y, v = start[0, c], start[1, c]
        out[0, 0, c] = y
        out[1, 0, c] = v
        for k in range(1, len(u)):
            p, s = u[k - 1, c], u[k, c]
            y, v = A[0, 0] * y + A[0, 1] * v + before[0] * p + now[0] * s, A[1, 0] * y + A[1, 1] * v + before[1] * p + now[1] * s
            out[0, k, c] = y
            out[1, k, c] = v


def oscillate(
    u: Array, period: float, frequency_hz: float, damping: float, past: Past | None = None, start: Array | None = None
) -> tuple[Array, Array, Array]:
    """Solves `y'' + 2 zeta w y' + w^2 y = w^2 u`; causal.

    Args:
        u: (N, c).
        period: of the samples, s.
        damping: zeta, a share of the critical one.
        past: of a run that comes in blocks.
        start: (2, c), `y - u` and y' in the run's first row; at rest where absent.

    Returns:
        y, y', y'', each (N, c).
    """
    w = 2.0 * np.pi * frequency_hz
    E = _transition(w, damping, period)
    constant = np.array([1.0, 0.0]) - E[:, 0]
    ramp = np.array([1.0, 0.0]) + (E - np.eye(2)) @ np.array([2.0 * damping / w, -1.0]) / period
    past = past or Past()
    whole, first = u, np.stack([u[0], np.zeros(u.shape[1])]) + (0.0 if start is None else start)
    if past.rows is not None:  # the last input, position and rate
        whole, first = np.concatenate([past.rows[:1], u]), past.rows[1:]
    out = np.empty((2, *whole.shape))
    _run(np.ascontiguousarray(whole), first, E, constant - ramp, ramp, out)
    y, rate = out[:, -len(u) :]
    past.rows = np.stack([u[-1], y[-1], rate[-1]])
    return y, rate, w * w * (u - y) - 2.0 * damping * w * rate


def oscillate_in_field(
    f: Array, field: Array, period: float, frequency_hz: float, damping: float, past: Past | None = None
) -> tuple[Array, Array, Array]:
    """Solves `y'' + 2 zeta w y' + (w^2 + k) y = f`, where a field makes it stiffer or softer as it turns; causal.

    Args:
        f: (N,), straight between samples. The oscillator rests under it in the run's first row.
        field: (N,), k, 1/s2; constant from sample to sample, at the mean of the two.
        period: of the samples, s.
        damping: zeta, a share of the critical one without the field.
        past: of a run that comes in blocks.

    Returns:
        y, y', y'', each (N,).
    """
    w = 2.0 * np.pi * frequency_hz
    past = past or Past()
    u: Array = np.column_stack((f, np.maximum(w * w + field, LEAST_STIFFNESS * w * w)))
    start = np.array([u[0], [f[0] / u[0, 1], 0.0]]) if past.rows is None else past.rows
    out = _run_in_field(u, start, damping * w, period, past.rows is None)
    y, rate, _ = out.T
    past.rows = np.stack([u[-1], [y[-1], rate[-1]]])
    return out[:, 0], out[:, 1], out[:, 2]


@njit(cache=True)
def _run_in_field(u: Array, start: Array, d: float, h: float, at_rest: bool) -> Array:
    """(N, 3), y and its two rates; u (N, 2) are force and stiffness, d half the damping, 1/s. `start` is the row before the first, or,
    `at_rest`, the first itself, above y and y' there."""
    out = np.empty((len(u), 3))
    before, y, v = start[0], start[1, 0], start[1, 1]
    fading = math.exp(-d * h)
    for k in range(len(u)):
        if k > 0 or not at_rest:
            K = 0.5 * (before[1] + u[k, 1])
            square = K - d * d
            root = math.sqrt(abs(square))
            if root * h < 1e-7:
                C, S = 1.0, h
            elif square > 0.0:
                C, S = math.cos(root * h), math.sin(root * h) / root
            else:
                C, S = math.cosh(root * h), math.sinh(root * h) / root
            slope = (u[k, 0] - before[0]) / (h * K)
            lag = 2.0 * d * slope / K
            # what is left beside the answer to a force that goes on straight dies out
            y, v = y - before[0] / K + lag, v - slope
            y, v = (
                fading * ((C + d * S) * y + S * v) + u[k, 0] / K - lag,
                fading * ((C - d * S) * v - K * S * y) + slope,
            )
        out[k, 0], out[k, 1], out[k, 2] = y, v, u[k, 0] - u[k, 1] * y - 2.0 * d * v
        before = u[k]
    return out


def _transition(w: float, damping: float, h: float) -> Array:
    """(2, 2), takes `[y, y']` over h seconds without input: the matrix exponential, written out."""
    root = w * cmath.sqrt(1.0 - damping**2)
    C = cmath.cos(root * h).real
    S = (cmath.sin(root * h) / root).real if abs(root) * h > 1e-7 else h
    return np.asarray(np.exp(-damping * w * h) * np.array([[C + damping * w * S, S], [-w * w * S, C - damping * w * S]]))


def spectral_peaks(residual: Array, period: float, lower_hz: float, upper_hz: float, count: int) -> list[float]:
    """Frequencies (Hz) at which the residual (N, c) has most power beyond its surroundings, largest first, each of a mode of its own."""
    x = residual - residual.mean(axis=0)
    size = 1 << max(6, int(np.log2(max(len(x), 64) / 4)))
    segments = [x[i : i + size] for i in range(0, max(1, len(x) - size + 1), size // 2)]
    window = np.hanning(size)[:, None]
    power = sum(np.sum(np.abs(np.fft.rfft(window[: len(s)] * s, n=size, axis=0)) ** 2, axis=1) for s in segments)
    f = np.fft.rfftfreq(size, period)
    level = np.asarray(power)
    inner = np.flatnonzero((f >= lower_hz) & (f <= upper_hz))
    inner = inner[(inner > 0) & (inner < len(f) - 1)]
    peaks = inner[(level[inner] >= level[inner - 1]) & (level[inner] >= level[inner + 1])]
    found: list[float] = []
    for frequency in f[peaks[np.argsort(-level[peaks])]]:
        if all(max(frequency, other) > APART * min(frequency, other) for other in found):
            found.append(float(frequency))
    return found[:count]
