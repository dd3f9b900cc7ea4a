"""Delays of tenths of a second, against SciPy's splines of loads that wait."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from core.array import Array
from core.effects.delay_of_clocks import DelayOfClocks
from core.payload.inertia import regressor
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = replace(scene(), noise=NOISE)
EFFECT = DelayOfClocks()


def come_late(late: float) -> Array:
    """(N, 6), the nominal wrench of so much earlier; before the run the arm rests."""
    return CubicSpline(RUN.t, RUN.nominal)(np.maximum(RUN.t - late, RUN.t[0]))


def left_by_twin(reading: Array) -> Array:
    """(N, 6), what the best payload and offsets leave of a reading, in standard deviations of the noise, with such noise."""
    columns = np.concatenate((regressor(RUN.motion), np.broadcast_to(np.eye(6), (len(RUN), 6, 6))), axis=2) / NOISE[:, None]
    columns = columns.reshape(-1, 16)
    seen = (reading / NOISE + np.random.default_rng(3).normal(size=reading.shape)).ravel()
    return np.asarray((seen - columns @ np.linalg.lstsq(columns, seen, rcond=None)[0]).reshape(-1, 6))


@pytest.mark.parametrize("late", [0.15, 0.3, 0.55, 0.95])
def test_a_delay_of_two_clocks_is_found_in_what_the_twin_leaves(late: float) -> None:
    starts = EFFECT.starts(RUN, left_by_twin(come_late(late)))
    assert min(abs(float(start[0]) - late) for start in starts) < 0.03
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, np.array([late])), come_late(late), atol=2e-3)


def test_small_delays_offsets_and_noise_are_no_sign_of_one() -> None:
    jump = np.where(RUN.t[:, None] > 7.0, [3.0, -1.0, 0.5, 0.1, 0.0, 0.2], 0.0)
    for reading in (RUN.nominal, come_late(0.02), come_late(0.06), RUN.nominal + jump, 1.1 * RUN.nominal):
        assert EFFECT.starts(RUN, left_by_twin(reading)) == []


def test_nothing_is_late_where_nothing_is_known_of_the_way_from_pose_to_pose() -> None:
    assert EFFECT.starts(replace(RUN, apart=True), left_by_twin(come_late(0.3))) == []
