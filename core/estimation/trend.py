"""Slow changes of an offset over a recording as a whole, as when a sensor warms up: a smooth trend whose size is sought.

A random walk is too rough for them: what it may do between two poses widens the intervals. The trend is a sum of Legendre polynomials in
time whose coefficients are independent, with variances that fall with the order as those of an integrated random walk do. Of a warm-up,
`1 - exp(-2 t / T)`, less than a hundredth is left beyond the last of them; that is the walk's.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import legvander

from core.array import Array

ORDERS = 4
"""At most: the fastest has a wave in half the recording."""
SHORTEST_WAVE_S = 20.0
"""What is as fast as the robot's motions would be taken for inertia, and inertia for it: shorter recordings have fewer orders, or none."""


@dataclass(frozen=True)
class Trend:
    """Between two instants.

    Args:
        first, last: s.
        shortest_wave_s: it may have; where nothing moves while it is seen, nothing else is as fast.
    """

    first: float
    last: float
    shortest_wave_s: float = SHORTEST_WAVE_S

    @property
    def orders(self) -> int:
        """How many a recording of this length has."""
        return min(ORDERS, int(2.0 * (self.last - self.first) / self.shortest_wave_s))

    def columns(self, t: Array) -> Array:
        """(N, p), at times t (N,), s: the first order, of unit variance, goes from -1 to 1."""
        u = (2.0 * t - self.first - self.last) / max(self.last - self.first, 1e-9)
        return np.asarray(legvander(u, self.orders)[:, 1:] / np.arange(1, self.orders + 1) ** 2)

    def columns_between(self, t: Array, seen: Array) -> Array:
        """(N, p), at times t (N,) less the straight lines between the nearest of the times at which it was seen (K,)."""
        here, at = self.columns(t), self.columns(seen)
        for k, column in enumerate(at.T):
            here[:, k] -= np.interp(t, seen, column)
        return here


@dataclass(frozen=True)
class FoundTrend:
    """What was found of the trends of six channels.

    Args:
        coefficients: (6, p), N and N m. covariance: (6, p, p), of each channel's.
    """

    trend: Trend
    coefficients: Array
    covariance: Array

    def between(self, t: Array, seen: Array) -> tuple[Array, Array]:
        """(N, 6) and its variance (N, 6), at times t (N,) about straight lines between the times at which it was seen (K,)."""
        columns = self.trend.columns_between(t, seen)
        return columns @ self.coefficients.T, np.einsum("np,cpq,nq->nc", columns, self.covariance, columns, optimize=True)
