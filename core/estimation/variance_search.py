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
from core.estimation.window_covariance import Factor, WindowCovariance, bands_of_product

LONGEST_FALL, LONGEST_RISE = np.log(100.0), np.log(5.0)
"""By which the logarithm of a size changes at once. Where a step rises too far, the payload is taken for noise, and never found again."""
LEAST = 1e-200
"""Of what is divided by."""
DAMPING = 1e-3
"""Share of a part of the noise that is always taken to be seen."""


@dataclass(frozen=True)
class Channel:
    """One channel's equations for what passes the filter over its windows, whitened.

    Args:
        factor: of its covariance. columns: (K, n), of the unknowns `rows` (n,). residual: (K,).
    """

    factor: Factor
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
        return np.clip(found, -LONGEST_FALL, LONGEST_RISE)


def slope_of(sizes: Array, parts: Sequence[WindowCovariance], channel: Channel, covariance: Array) -> Slope:
    """Of one channel.

    Args:
        sizes: (p,). parts: what a part of unit size adds. covariance: (m, m), of all unknowns.
    """
    known, factor = covariance[np.ix_(channel.rows, channel.rows)], channel.factor
    u = factor.solve_transposed(np.column_stack((channel.residual, channel.columns)))
    bands = max(len(part.bands) for part in parts)
    projection = factor.inverse[:bands] - bands_of_product(u[:, 1:] @ known, u[:, 1:], min(bands, len(factor.inverse)))
    moved = np.column_stack([part.multiply(u[:, :1]) for part in parts])
    common = [part.columns for part in parts]
    white = factor.whiten(np.column_stack((moved, *common)))
    along = white.T @ channel.columns
    passed = np.einsum("ki,ki->i", white, white) - np.einsum("in,nm,im->i", along, known, along, optimize=True)
    ends = np.cumsum([len(parts), *(each.shape[1] for each in common)])
    expected = [part.trace_with(projection) + passed[a:b].sum() for part, a, b in zip(parts, ends, ends[1:], strict=False)]
    seen, n = np.maximum(u[:, 0] @ moved, LEAST), len(parts)
    share = white[:, :n].T @ white[:, :n] - along[:n] @ known @ along[:n].T
    return Slope(seen / np.maximum(expected, LEAST), share * sizes / seen[:, None])


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
        self._reach, self._last = np.full(sizes.shape, LONGEST_FALL), np.zeros(sizes.shape)

    def begin(self) -> None:
        """The search goes on in another model: nothing is known of where its maxima lie."""
        self._reach[:], self._last[:] = LONGEST_FALL, 0.0

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
