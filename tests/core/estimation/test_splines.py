"""Against SciPy's splines, which share no code with them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

from core.estimation.splines import cardinal, cubic_pieces, cubic_slopes


def test_pieces_and_slopes_of_cubic_splines_are_those_of_scipy() -> None:
    spline = BSpline.basis_element(np.arange(-2.0, 3.0), extrapolate=False)
    u = np.linspace(0.0, 0.999, 40)
    for k in range(4):
        np.testing.assert_allclose(cubic_pieces(u)[:, k], spline(u + k - 2.0), atol=1e-14)
        np.testing.assert_allclose(cubic_slopes(u)[:, k], spline.derivative()(u + k - 2.0), atol=1e-14)


@pytest.mark.parametrize("degree", [1, 3, 4, 7])
def test_cardinal_splines_are_those_of_scipy(degree: int) -> None:
    half = 0.5 * (degree + 1)
    x = np.linspace(-half + 1e-9, half - 1e-9, 301)
    expected = BSpline.basis_element(np.arange(degree + 2) - half, extrapolate=False)(x)
    np.testing.assert_allclose(cardinal(x, degree), expected, atol=1e-13)
    assert not cardinal(np.array([-half - 0.1, half, 9.0]), degree).any()
