"""Compiled rows against windows, covariance and a dense factor."""

from __future__ import annotations

import numpy as np
from scipy.linalg import cholesky, solve_triangular
from scipy.sparse import csr_array

from core.estimation.banded import bands_of, factorise
from core.gap.kinematic_noise import rate_matrix
from core.gap.whitener import Whitener
from core.gap.windows import window_matrix


def test_rows_are_windowed_means_with_the_inverse_factor_of_their_covariance() -> None:
    rng = np.random.default_rng(0)
    t = 0.005 * np.arange(300)
    W = window_matrix(np.arange(0.1, 1.4, 0.025), 0.025, t)
    of_noise = csr_array(W @ W.T)
    scales = rng.uniform(0.5, 2.0, 6)
    whitener = Whitener(W, [factorise(scale * bands_of(of_noise)) for scale in scales])
    wrench = rng.normal(size=(300, 6))
    dense = [
        solve_triangular(cholesky(scale * of_noise.toarray(), lower=True), W.toarray() @ wrench[:, c], lower=True)
        for c, scale in enumerate(scales)
    ]
    np.testing.assert_allclose(whitener.average_and_whiten(wrench), dense, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(whitener.whiten(W @ wrench), dense, rtol=1e-9, atol=1e-9)


def test_rates_are_those_of_numpy_with_a_gap_in_time_as_well() -> None:
    t = np.concatenate((0.005 * np.arange(50), 3.0 + 0.005 * np.arange(40)))
    x = np.random.default_rng(1).normal(size=(90, 4))
    np.testing.assert_allclose(rate_matrix(t) @ x, np.gradient(x, t, axis=0), rtol=1e-9, atol=1e-9)
