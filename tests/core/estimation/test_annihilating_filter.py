"""The filter against dense matrices, and what it lets pass of constants and exponentials."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from core.estimation.annihilating_filter import AnnihilatingFilter

TIMES = (2.0, 20.0)
SEEDS, COUNTS = st.integers(0, 2**32 - 1), st.integers(1, 40)


def knots_of(seed: int, n: int) -> np.ndarray:
    """Even but for a few pauses, one of which may be long."""
    steps = np.where(np.random.default_rng(seed).random(n) < 0.15, 7.0, 1.0)
    steps[n // 2] = 5e4
    return np.cumsum(steps)


def dense(found: AnnihilatingFilter) -> np.ndarray:
    return found.apply(np.eye(found.weights.shape[1]))


@given(SEEDS, st.integers(8, 40))
def test_neither_a_constant_nor_a_decay_passes_behind_the_first_windows(seed: int, n: int) -> None:
    knots = knots_of(seed, n)
    D = dense(AnnihilatingFilter.of(knots, TIMES))
    near = knots < knots[n // 2]  # a decay that has been falling through a long pause is nothing
    for column in (np.ones(n), *(np.exp(-(knots - knots[0]) / each) for each in TIMES)):
        rows = np.arange(n) >= 3
        assert np.abs(D @ column)[rows & (near | (column == 1.0).all())].max(initial=0.0) < 1e-6
    np.testing.assert_array_equal(np.triu(D), np.eye(n))


@given(SEEDS, COUNTS)
def test_covariances_and_the_ways_back_are_those_of_the_dense_matrix(seed: int, n: int) -> None:
    rng = np.random.default_rng(seed)
    found = AnnihilatingFilter.of(knots_of(seed, n), TIMES)
    D, bands = dense(found), rng.normal(size=(5, n))
    G = sum(np.diag(bands[d, : n - d], -d) + (np.diag(bands[d, : n - d], d) if d else 0.0) for d in range(min(5, n)))
    expected, passed = D @ G @ D.T, found.covariance(bands)
    assert passed.shape == (8, n)
    for d in range(8):
        np.testing.assert_allclose(passed[d, : max(n - d, 0)], np.diag(expected, -d), atol=1e-9)
        assert not passed[d, max(n - d, 0) :].any()
    x = rng.normal(size=(n, 2))
    np.testing.assert_allclose(found.undo(D @ x), x, atol=1e-6)
    np.testing.assert_allclose(found.undo_transposed(D.T @ x), x, atol=1e-6)
