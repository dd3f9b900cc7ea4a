"""A filter over neighbouring windows through which neither a constant nor a decaying exponential passes.

What is left of a random walk and of Ornstein-Uhlenbeck processes with these time constants is what has been added within a few windows, so
that its covariance is banded however long the recording is. The weights solve Prony's equations, for windows at any distances.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit

from core.array import Array
from core.estimation.banded import solve_transposed, whiten

LONGEST_STEP = 10.0
"""Time constants that two windows are taken to be apart at most: after a longer pause next to nothing of an exponential is left."""


@dataclass(frozen=True)
class AnnihilatingFilter:
    """A lower triangular matrix with ones on its diagonal.

    Args:
        weights: (p + 1, K), on each window and on the p before it; those of the first p are differences, the first stands for itself.
    """

    weights: Array

    @classmethod
    def of(cls, knots: Array, time_constants: tuple[float, ...]) -> AnnihilatingFilter:
        """For windows at knots (K,), in increasing order, and exponentials with time constants in knots; constants never pass."""
        p, n = 1 + len(time_constants), len(knots)
        weights = np.zeros((p + 1, n))
        weights[0], weights[1, 1:p] = 1.0, -1.0
        steps = np.diff(knots, prepend=knots[:1])
        left = [np.ones((n, p + 1))]
        for time_constant in time_constants:
            since = np.cumsum(np.minimum(steps / time_constant, LONGEST_STEP))
            left.append(np.column_stack([np.exp(_shift(since, p) - _shift(since, j)) for j in range(p + 1)]))
        rows = np.stack(left, axis=1)[p:]
        if len(rows):
            weights[1:, p:] = np.linalg.solve(rows[:, :, 1:], -rows[:, :, :1])[..., 0].T
        return cls(weights)

    @property
    def reach(self) -> int:
        """How many windows before it a row sees."""
        return len(self.weights) - 1

    def apply(self, x: Array) -> Array:
        """(K, n), of columns x (K, n)."""
        found = self.weights[0][:, None] * x
        for j in range(1, min(len(self.weights), len(x))):
            found[j:] += self.weights[j, j:, None] * x[:-j]
        return np.asarray(found)

    def covariance(self, bands: Array, count: int | None = None) -> Array:
        """(count, K), lower bands of the covariance of what passes, from those of windows (b, K); `b + reach` of them where absent."""
        return np.asarray(_filter_both_sides(self.weights, bands, len(bands) + self.reach if count is None else count))

    def undo(self, x: Array) -> Array:
        """(K, n), of which the filter makes x (K, n)."""
        return whiten(self._columns, x)

    def undo_transposed(self, x: Array) -> Array:
        """(K, n), of which the transposed filter makes x (K, n)."""
        return solve_transposed(self._columns, x)

    @property
    def _columns(self) -> Array:
        """(p + 1, K), its lower bands."""
        bands = np.zeros_like(self.weights)
        for j, row in enumerate(self.weights[: self.weights.shape[1]]):
            bands[j, : len(row) - j] = row[j:]
        return bands


def _shift(x: Array, j: int) -> Array:
    """The j-th value before each; those before the first are the first."""
    return x[np.maximum(np.arange(len(x)) - j, 0)]


@njit(cache=True)
def _filter_both_sides(weights: Array, bands: Array, count: int) -> Array:
    p, n = weights.shape
    found = np.zeros((count, n))
    for k in range(n):
        for d in range(min(count, n - k)):
            row, total = k + d, 0.0
            for i in range(min(p, row + 1)):
                for j in range(min(p, k + 1)):
                    lag = abs(d + j - i)
                    if lag < len(bands):
                        total += weights[i, row] * weights[j, k] * bands[lag, min(row - i, k - j)]
            found[d, k] = total
    return found
