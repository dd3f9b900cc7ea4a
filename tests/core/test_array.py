"""Values between samples."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import make_interp_spline

from core.array import interpolate

T = np.array([0.0, 0.3, 0.4, 1.0])


def test_rotations_and_channels_lie_on_straight_lines_between_their_samples() -> None:
    x = np.random.default_rng(3).normal(size=(4, 3, 2))
    at = np.linspace(0.0, 1.0, 23)
    np.testing.assert_allclose(interpolate(at, T, x), make_interp_spline(T, x, k=1)(at), atol=1e-14)


def test_before_the_first_and_after_the_last_sample_holds_the_nearest() -> None:
    x = np.array([5.0, 1.0, 2.0, 7.0])
    np.testing.assert_array_equal(interpolate(np.array([-1.0, 2.0]), T, x), [5.0, 7.0])
