"""B-splines on even knots, in closed form.

SciPy has them in `scipy.interpolate`, which loads all of `scipy.optimize`: a fifth of a second of processor time before anything is
estimated.
"""

from __future__ import annotations

from math import comb, factorial

import numpy as np

from core.array import Array


def cubic_pieces(u: Array) -> Array:
    """(..., 4), at a share u (...,) of the way from a knot to the next: of the cubic splines that begin there and 1, 2, 3 knots before."""
    v = 1.0 - u
    return np.stack((u**3, 1.0 + 3.0 * u * (1.0 + u * v), 1.0 + 3.0 * v * (1.0 + u * v), v**3), axis=-1) / 6.0


def cubic_slopes(u: Array) -> Array:
    """(..., 4), derivatives of `cubic_pieces` by u."""
    v = 1.0 - u
    return np.stack((u**2, 1.0 + 2.0 * u - 3.0 * u**2, 3.0 * v**2 - 2.0 * v - 1.0, -(v**2)), axis=-1) / 2.0


def cardinal(x: Array, degree: int) -> Array:
    """(...,), the spline about 0 with unit spacing, by truncated powers (Schoenberg 1946)."""
    away = 0.5 * (degree + 1) - np.abs(x)
    terms = [(-1) ** j * comb(degree + 1, j) * np.maximum(away - j, 0.0) ** degree for j in range((degree + 1) // 2 + 1)]
    return np.asarray(sum(terms) / factorial(degree))
