"""Covariances of windows that overlap with their neighbours only: lower bands (b, K), and what is made with their factors."""

from __future__ import annotations

import numpy as np
from numba import njit
from scipy.linalg import cholesky_banded
from scipy.linalg.lapack import dtbtrs
from scipy.sparse import csr_array

from core.array import Array

BAND = 5
"""Cubic B-splines overlap with three neighbours on each side, and second differences of what was seen reach one window further."""


def bands_of(matrix: csr_array, count: int = BAND) -> Array:
    """(count, K), lower bands of a sparse symmetric matrix (K, K)."""
    n = matrix.shape[0]
    bands = np.zeros((count, n))
    for k in range(min(count, n)):
        bands[k, : n - k] = matrix.diagonal(-k)
    return bands


def count_bands(matrix: csr_array) -> int:
    """How many lower bands hold all of a sparse symmetric matrix."""
    rows = np.repeat(np.arange(matrix.shape[0]), np.diff(matrix.indptr))
    return 1 + int(np.abs(rows - matrix.indices).max(initial=0))


def factorise(bands: Array) -> Array:
    """(b, K), lower bands of L, where `L L^T` is the covariance."""
    return np.asarray(cholesky_banded(bands, lower=True))


def whiten(factor: Array, x: Array) -> Array:
    """`L^-1 x` for a factor (b, K) and x (K, n)."""
    solved, info = dtbtrs(factor, x, uplo="L")
    if info != 0:
        raise FloatingPointError("the covariance of the windows is singular")
    return np.asarray(solved)


def solve_transposed(factor: Array, x: Array) -> Array:
    """`L^-T x` for a factor (b, K) and x (K, n)."""
    solved, info = dtbtrs(factor, x, uplo="L", trans="T")
    if info != 0:
        raise FloatingPointError("the covariance of the windows is singular")
    return np.asarray(solved)


def multiply(bands: Array, x: Array) -> Array:
    """Product (K, n) of a symmetric matrix, lower bands (b, K), and x (K, n)."""
    product = bands[0][:, None] * x
    for d in range(1, min(len(bands), len(x))):
        side = bands[d, :-d, None]
        product[d:] += side * x[:-d]
        product[:-d] += side * x[d:]
    return np.asarray(product)


@njit(cache=True)
def invert(factor: Array) -> Array:
    """(b, K), lower bands of the covariance's inverse, from the last column to the first (Takahashi, Fagan and Chin 1973)."""
    b, n = factor.shape
    inverse = np.zeros((b, n))
    for i in range(n - 1, -1, -1):
        reach = min(b - 1, n - 1 - i)
        for d in range(reach, -1, -1):
            j, total = i + d, 0.0
            for k in range(i + 1, i + reach + 1):
                low, high = min(j, k), max(j, k)
                total += factor[k - i, i] * inverse[high - low, low]
            inverse[d, i] = ((1.0 / factor[0, i] if d == 0 else 0.0) - total) / factor[0, i]
    return inverse


def trace(inverse: Array, bands: Array) -> Array:
    """(...,), of the products of two symmetric matrices, lower bands (b, K) and (..., b, K)."""
    twice = np.full(len(inverse), 2.0)
    twice[0] = 1.0
    return np.asarray(np.einsum("b,bk,...bk->...", twice, inverse, bands))
