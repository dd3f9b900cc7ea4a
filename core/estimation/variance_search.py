"""Sizes of the parts of the noise where the restricted likelihood is largest, by the average information.

Gilmour, Thompson and Cullis 1995 (Biometrics 51). All that is needed of the projection P of the residuals are the bands of it in which the
covariances of the parts have any.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.banded import invert, multiply, solve_transposed, trace, whiten

LONGEST_STEP = np.log(100.0)
"""By which the logarithm of a size changes at once."""
LEAST = 1e-200
"""Of what is divided by."""
DAMPING = 1e-3
"""Share of a part of the noise that is always taken to be seen."""


@dataclass(frozen=True)
class Channel:
    """One channel's equations for what passes the filter over its windows, whitened.

    Args:
        factor: (b, K), of its covariance. columns: (K, n), of the unknowns `rows` (n,). residual: (K,).
    """

    factor: Array
    columns: Array
    rows: NDArray[np.intp]
    residual: Array


@dataclass(frozen=True)
class Slope:
    """How the restricted likelihood changes with the sizes of p parts of a channel's noise.

    Args:
        ratio: (p,), `r' P V P r / tr(P V)` of each part's covariance V, 1 where the likelihood is largest, more where the part is larger.
        share: (p, p), by which the logarithm of a ratio falls when that of a size rises: how much of the part the others let through.
    """

    ratio: Array
    share: Array

    def step(self, free: NDArray[np.bool_]) -> Array:
        """(p,), Newton's, of the logarithms of the sizes that are free (p,) towards the largest likelihood."""
        found = np.zeros(len(self.ratio))
        share = self.share[np.ix_(free, free)]
        share[np.diag_indices_from(share)] = np.maximum(np.diag(share) * (1.0 + DAMPING), DAMPING)
        found[free] = np.linalg.solve(share, np.log(self.ratio[free]))
        return np.clip(found, -LONGEST_STEP, LONGEST_STEP)


def slope_of(sizes: Array, parts: Sequence[Array], channel: Channel, covariance: Array) -> Slope:
    """Of one channel.

    Args:
        sizes: (p,). parts: (b, K) each, lower bands of what a part of unit size adds. covariance: (m, m), of all unknowns.
    """
    known = covariance[np.ix_(channel.rows, channel.rows)]
    u = solve_transposed(channel.factor, np.column_stack((channel.residual, channel.columns)))
    projection = invert(channel.factor) - _bands_of_product(u[:, 1:] @ known, u[:, 1:], len(channel.factor))
    moved = np.column_stack([multiply(bands, u[:, :1]) for bands in parts])
    seen = np.maximum(u[:, 0] @ moved, LEAST)
    expected = np.maximum([float(trace(projection, bands)) for bands in parts], LEAST)
    white = whiten(channel.factor, moved)
    along = white.T @ channel.columns
    return Slope(seen / expected, (white.T @ white - along @ known @ along.T) * sizes / seen[:, None])


def _bands_of_product(x: Array, y: Array, count: int) -> Array:
    """(count, K), lower bands of `y x'` for two (K, n)."""
    found = np.zeros((count, len(x)))
    for d in range(min(count, len(x))):
        found[d, : len(x) - d] = np.einsum("ki,ki->k", y[d:], x[: len(x) - d])
    return found


class VarianceSearch:
    """The sizes of the parts of each channel's noise on their way to the largest restricted likelihood.

    Where one part hides most of another, the likelihood is flat and Newton's step leads past the maximum and back for ever. So a step that
    turns back halves how far the size of this part goes from now on: the search ends between two places, as a bisection does.

    Args:
        sizes: (6, p), where the search begins. least, most: (6, p), bounds; what these leave no room stays where it is.
    """

    def __init__(self, sizes: Array, least: Array, most: Array) -> None:
        self._least, self._most = least, np.maximum(least, most)
        self.sizes = np.clip(sizes, self._least, self._most)
        self._reach, self._last = np.full(sizes.shape, LONGEST_STEP), np.zeros(sizes.shape)

    def begin(self) -> None:
        """The search goes on in another model: nothing is known of where its maxima lie."""
        self._reach[:], self._last[:] = LONGEST_STEP, 0.0

    def sought(self, c: int) -> NDArray[np.intp]:
        """Parts of a channel whose size is not known before."""
        return np.flatnonzero(self._most[c] > self._least[c])

    def improve(self, c: int, slope: Slope) -> None:
        """One step of one channel, whose slope is that of the parts that are sought."""
        parts = self.sought(c)
        sizes, least, most = self.sizes[c, parts], self._least[c, parts], self._most[c, parts]
        free = np.where(slope.ratio < 1.0, sizes > least, sizes < most)
        step = slope.step(free)
        self._reach[c, parts] = np.where(step * self._last[c, parts] < 0.0, 0.5, 1.0) * self._reach[c, parts]
        self._last[c, parts] = step = np.clip(step, -self._reach[c, parts], self._reach[c, parts])
        self.sizes[c, parts] = np.clip(sizes * np.exp(step), least, most)
