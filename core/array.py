"""The type of nearly every number in the engine, and its values between samples."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Doubles; docstrings say their shape and unit."""


def interpolate(at: Array, t: Array, x: Array) -> Array:
    """(M, ...), channels x (N, ...) of rising times t (N,), on straight lines at times at (M,); before and after them the nearest."""
    channels = [np.interp(at, t, channel) for channel in x.reshape(len(t), -1).T]
    return np.stack(channels, axis=-1).reshape(len(at), *x.shape[1:])
