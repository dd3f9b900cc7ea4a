"""Against SciPy's filter, which shares no code with it."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import savgol_filter

from core.estimation.local_polynomial import derive, derive_with_ends_held


@pytest.mark.parametrize(("length", "degree", "order"), [(5, 3, 0), (5, 2, 2), (21, 3, 1), (101, 1, 0), (161, 3, 2)])
def test_derivatives_are_those_of_scipy_in_the_middle_and_at_the_ends(length: int, degree: int, order: int) -> None:
    x, period = np.cumsum(np.random.default_rng(length).normal(size=(400, 3)), axis=0), 0.004
    for ours, mode in ((derive, "interp"), (derive_with_ends_held, "nearest")):
        expected = savgol_filter(x, length, degree, deriv=order, delta=period, axis=0, mode=mode)
        np.testing.assert_allclose(ours(x, length, degree, order, period), expected, rtol=1e-8, atol=1e-9 * np.abs(expected).max())


def test_samples_of_one_column_alone_are_smoothed() -> None:
    t = np.arange(300.0) + np.random.default_rng(0).normal(scale=0.1, size=300)
    np.testing.assert_allclose(derive(t, 101, 1), savgol_filter(t, 101, 1), atol=1e-9)
