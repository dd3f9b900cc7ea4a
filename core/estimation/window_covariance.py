"""Covariance of one channel's windows: banded, and of low rank what all of them have in common."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.array import Array
from core.estimation.banded import factorise, invert, multiply, solve_transposed, trace, whiten

LEAST = 1e-9
"""Of what a common column adds to the banded variance: below it rounding decides, and it adds nothing."""


@dataclass(frozen=True)
class WindowCovariance:
    """`banded + columns columns'`.

    Args:
        bands: (b, K), lower ones. columns: (K, p), few.
    """

    bands: Array
    columns: Array

    def multiply(self, x: Array) -> Array:
        """(K, n), with x (K, n)."""
        return multiply(self.bands, x) + self.columns @ (self.columns.T @ x)

    def factorise(self) -> Factor:
        """Its factor."""
        return Factor.of(factorise(self.bands), self.columns)

    def trace_with(self, inverse: Array) -> float:
        """Trace of the product of the banded part with a symmetric matrix, lower bands (b, K) or more."""
        return float(trace(inverse[: len(self.bands)], self.bands))


@dataclass(frozen=True)
class Factor:
    """`L H^-1`, where `L L'` is the banded part and `H = (1 + Z Z')^(-1/2)`, symmetric, with `L Z` the common columns.

    Args:
        banded: (b, K), lower bands of L. common: (K, p), orthogonal columns that Z spans. added: (p,), their squared lengths.
    """

    banded: Array
    common: Array
    added: Array

    @classmethod
    def of(cls, banded: Array, columns: Array) -> Factor:
        """Of the factor (b, K) of the banded part and the common columns (K, p)."""
        if not columns.shape[1]:
            return cls(banded, columns, np.zeros(0))
        Z = whiten(banded, columns)
        added, directions = np.linalg.eigh(Z.T @ Z)
        return cls(banded, Z @ directions, np.maximum(added, LEAST))

    def whiten(self, x: Array) -> Array:
        """(K, n), x (K, n) with unit covariance."""
        return self._shrink(whiten(self.banded, x)) if x.shape[1] else x  # LAPACK ends the program for no columns

    def solve_transposed(self, x: Array) -> Array:
        """(K, n), of whitened x (K, n) the product of the inverse with what it was before."""
        return solve_transposed(self.banded, self._shrink(x))

    @cached_property
    def inverse(self) -> Array:
        """(b, K), lower bands of the inverse."""
        bands = np.asarray(invert(self.banded))
        if not len(self.added):
            return bands
        common = solve_transposed(self.banded, self.common) / np.sqrt(1.0 + self.added)
        return np.asarray(bands - bands_of_product(common, common, len(bands)))

    def _shrink(self, x: Array) -> Array:
        """`H x`."""
        if not len(self.added):
            return x
        return np.asarray(x - self.common @ (((1.0 - 1.0 / np.sqrt(1.0 + self.added)) / self.added)[:, None] * (self.common.T @ x)))


def bands_of_product(x: Array, y: Array, count: int) -> Array:
    """(count, K), lower bands of `y x'` for two (K, n)."""
    found = np.zeros((count, len(x)))
    for d in range(min(count, len(x))):
        found[d, : len(x) - d] = np.einsum("ki,ki->k", y[d:], x[: len(x) - d])
    return found
