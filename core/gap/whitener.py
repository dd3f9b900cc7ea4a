"""From wrenches on the scene's grid to whitened rows, compiled: what a fit does once for each parameter and step."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.sparse import csr_array

from core.array import Array


class Whitener:
    """Windows and the covariance of what is seen through them.

    Args:
        average: (K, N), windowed means over the grid.
        factors: (b, K) for each of six channels, lower bands of the Cholesky factor of the covariance of its windows.
    """

    def __init__(self, average: csr_array, factors: list[Array]) -> None:
        self._average = (average.data, average.indices.astype(np.uintp), average.indptr.astype(np.uintp))
        bands = np.stack(factors)  # (6, b, K)
        by_row = np.zeros((bands.shape[2], bands.shape[1], 6))
        for d in range(min(bands.shape[1:])):
            by_row[d:, d] = bands[:, d, : bands.shape[2] - d].T
        self._by_row = by_row

    def average_and_whiten(self, wrench: Array) -> Array:
        """(6, K), rows with unit noise, of a wrench (N, 6) on the grid, N and N m."""
        return np.asarray(_average_and_whiten(*self._average, np.ascontiguousarray(wrench), self._by_row))

    def whiten(self, windowed: Array) -> Array:
        """The same of a wrench (K, 6) that is windowed already."""
        return np.asarray(_whiten(np.ascontiguousarray(windowed), self._by_row))


@njit(cache=True)
def _average_and_whiten(data: Array, indices: NDArray[np.uintp], indptr: NDArray[np.uintp], wrench: Array, by_row: Array) -> Array:
    windowed = np.empty((len(indptr) - 1, 6))
    for k in range(len(windowed)):
        fx = fy = fz = tx = ty = tz = 0.0
        for p in range(indptr[k], indptr[k + 1]):
            weight, row = data[p], wrench[indices[p]]
            fx += weight * row[0]
            fy += weight * row[1]
            fz += weight * row[2]
            tx += weight * row[3]
            ty += weight * row[4]
            tz += weight * row[5]
        windowed[k, 0], windowed[k, 1], windowed[k, 2] = fx, fy, fz
        windowed[k, 3], windowed[k, 4], windowed[k, 5] = tx, ty, tz
    whitened: Array = _whiten(windowed, by_row)
    return whitened


@njit(cache=True)
def _whiten(windowed: Array, by_row: Array) -> Array:
    """Forward substitution, all channels abreast."""
    K, b = by_row.shape[:2]
    y = np.empty((K, 6))
    for k in range(K):
        for c in range(6):
            y[k, c] = windowed[k, c]
        for d in range(1, min(b - 1, k) + 1):
            for c in range(6):
                y[k, c] -= by_row[k, d, c] * y[k - d, c]
        for c in range(6):
            y[k, c] /= by_row[k, 0, c]
    return y.T.copy()
