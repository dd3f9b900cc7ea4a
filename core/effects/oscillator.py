"""A damped oscillator driven sample by sample, exact for an input that is linear between samples."""

from __future__ import annotations

import cmath

import numpy as np
from numba import njit

from core.array import Array
from core.effects.memory import Past


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


def _transition(w: float, damping: float, h: float) -> Array:
    """(2, 2), takes `[y, y']` over h seconds without input: the matrix exponential, written out."""
    root = w * cmath.sqrt(1.0 - damping**2)
    C = cmath.cos(root * h).real
    S = (cmath.sin(root * h) / root).real if abs(root) * h > 1e-7 else h
    return np.asarray(np.exp(-damping * w * h) * np.array([[C + damping * w * S, S], [-w * w * S, C - damping * w * S]]))


def spectral_peaks(residual: Array, period: float, lower_hz: float, upper_hz: float, count: int) -> list[float]:
    """Frequencies (Hz) at which the residual (N, c) has most power beyond its surroundings, largest first."""
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
    return [float(f[i]) for i in peaks[np.argsort(-level[peaks])][:count]]
