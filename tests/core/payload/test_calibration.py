"""What a certificate states of gains and cross-talk, as a matrix of what a channel reads per load of another."""

from __future__ import annotations

import numpy as np
import pytest

from core.payload.calibration import NOT_STATED, SensorCalibration, reading_std

RANGE = np.array([100.0, 100.0, 200.0, 5.0, 5.0, 10.0])


def test_gains_stand_on_the_diagonal_and_full_load_beside_makes_the_stated_share_of_the_range() -> None:
    stated = SensorCalibration(gain_std=(0.01, 0.02, 0.03, 0.04, 0.05, 0.06), crosstalk_std=(0.001, 0.002, 0.003, 0.004, 0.005, 0.006))
    std = reading_std(stated, RANGE)
    np.testing.assert_allclose(np.diag(std), [0.01, 0.02, 0.03, 0.04, 0.05, 0.06])
    full_load_of_fz = np.array([0.0, 0.0, 200.0, 0.0, 0.0, 0.0])
    np.testing.assert_allclose((std @ full_load_of_fz)[[0, 3, 5]], [0.1, 0.004 * 5.0, 0.006 * 10.0])


@pytest.mark.parametrize("measuring_range", [RANGE, None])
def test_where_nothing_is_stated_one_per_cent_and_half_a_per_cent_are_assumed(measuring_range: np.ndarray | None) -> None:
    std = reading_std(NOT_STATED, measuring_range)
    np.testing.assert_allclose(np.diag(std), 0.01)
    assert std[0, 1] == pytest.approx(0.005)
