"""Banded covariances against the dense matrices that they stand for."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import csr_array

from core.estimation.banded import (
    BAND,
    bands_of,
    factorise,
    invert,
    multiply,
    solve_transposed,
    trace,
    whiten,
)


def covariance(seed: int, n: int) -> np.ndarray:
    """(n, n), what overlapping windows would have: positive definite, nothing beyond the band.

    The diagonal of its factor outweighs the rest of each row: else the dense inverse, the oracle, is off by more than the tolerance.
    """
    rng = np.random.default_rng(seed)
    below = np.subtract.outer(np.arange(n), np.arange(n))
    root = np.where((below >= 0) & (below < BAND), rng.uniform(-0.9, 0.9, size=(n, n)) / (BAND - 1), 0.0)
    np.fill_diagonal(root, 1.0)
    root *= rng.uniform(0.5, 2.0, n)[:, None]
    return np.asarray(root @ root.T)


@given(st.integers(0, 2**32 - 1), st.integers(1, 30))
def test_the_bands_of_the_inverse_are_those_of_the_dense_inverse(seed: int, n: int) -> None:
    C = covariance(seed, n)
    dense = np.linalg.inv(C)
    found = invert(factorise(bands_of(csr_array(C))))
    for k in range(min(BAND, n)):
        np.testing.assert_allclose(found[k, : n - k], np.diag(dense, -k), rtol=1e-6, atol=1e-8 * np.abs(dense).max())


@given(st.integers(0, 2**32 - 1), st.integers(1, 30))
def test_the_trace_of_a_product_needs_the_bands_alone(seed: int, n: int) -> None:
    C, G = covariance(seed, n), covariance(seed + 1, n)
    inverse = invert(factorise(bands_of(csr_array(C))))
    assert trace(inverse, bands_of(csr_array(G))) == pytest.approx(np.trace(np.linalg.inv(C) @ G), rel=1e-6)


def test_what_is_whitened_has_unit_covariance() -> None:
    C = covariance(0, 12)
    half = whiten(factorise(bands_of(csr_array(C))), np.eye(12))
    np.testing.assert_allclose(half @ C @ half.T, np.eye(12), atol=1e-9)


@given(st.integers(0, 2**32 - 1), st.integers(1, 30))
def test_products_and_the_way_back_are_those_of_the_dense_matrices(seed: int, n: int) -> None:
    C, x = covariance(seed, n), np.random.default_rng(seed).normal(size=(n, 3))
    bands = bands_of(csr_array(C))
    np.testing.assert_allclose(multiply(bands, x), C @ x, atol=1e-9 * np.abs(C).max())
    L = np.linalg.cholesky(C)
    expected = np.linalg.solve(L.T, x)
    np.testing.assert_allclose(solve_transposed(factorise(bands), x), expected, rtol=1e-6, atol=1e-6 * np.abs(expected).max())
