"""What cubic B-splines show of rows, as the windows of a recording show its readings."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import BSpline
from scipy.ndimage import convolve1d

from core.array import Array


def smooth_by_splines(x: Array, period: float, spacing: float) -> Array:
    """`x` (N, n) averaged over cubic B-splines round each row, the first and last row going on; `x` itself without a spacing.

    Args:
        period: of the rows, s.
        spacing: of the knots, s.
    """
    reach = int(2.0 * spacing / period)
    if reach == 0:
        return x
    spline = BSpline.basis_element(np.arange(-2.0, 3.0) * spacing)
    weights = np.maximum(spline(np.arange(-reach, reach + 1) * period), 0.0)
    return np.asarray(convolve1d(x, weights / weights.sum(), axis=0, mode="nearest"))
