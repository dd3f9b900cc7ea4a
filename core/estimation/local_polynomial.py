"""Derivatives without lag from polynomials through the samples around each one (Savitzky and Golay 1964).

SciPy has it in `scipy.signal`, which loads all of `scipy.stats`: a third of a second of processor time before anything is estimated, and
`scipy.ndimage` takes half as long.
"""

from __future__ import annotations

from math import factorial

import numpy as np

from core.array import Array


def weights_of(length: int, degree: int, order: int, period: float, at: Array | float = 0.0) -> Array:
    """(..., length), of evenly spaced samples in the derivative, of some order, of the polynomial that is laid through them.

    Args:
        length: odd. at: (...,), samples after the middle one at which the derivative is taken.
    """
    half = length // 2
    # in shares of the half, so that high powers stay small
    x = np.arange(-half, half + 1) / max(half, 1)
    powers = np.arange(degree + 1 - order)
    falling = np.array([factorial(n + order) / factorial(n) for n in powers])
    slope = falling * np.power.outer(np.asarray(at, dtype=float) / max(half, 1), powers)
    coefficients = np.linalg.pinv(np.vander(x, degree + 1, increasing=True))[order:]
    return np.asarray(slope @ coefficients / (max(half, 1) * period) ** order)


def derive_with_ends_held(x: Array, length: int, degree: int, order: int, period: float) -> Array:
    """(N, ...), of samples (N, ...), as if the first and the last of them had been there for ever."""
    weights, half = weights_of(length, degree, order, period), length // 2
    held = np.pad(x, [(half, half)] + [(0, 0)] * (x.ndim - 1), mode="edge").reshape(len(x) + 2 * half, -1)
    return np.stack([np.correlate(column, weights, "valid") for column in held.T], axis=-1).reshape(x.shape)


def derive(x: Array, length: int, degree: int, order: int = 0, period: float = 1.0) -> Array:
    """(N, ...), of at least `length` samples (N, ...), by the first and the last polynomial near the ends."""
    found, half = derive_with_ends_held(x, length, degree, order, period), length // 2
    before = weights_of(length, degree, order, period, np.arange(-half, 0, dtype=np.float64))
    after = weights_of(length, degree, order, period, np.arange(1, half + 1, dtype=np.float64))
    found[:half] = np.tensordot(before, x[:length], axes=1)
    found[len(x) - half :] = np.tensordot(after, x[-length:], axes=1)
    return found
