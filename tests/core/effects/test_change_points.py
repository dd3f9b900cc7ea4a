"""Where the mean of a series jumps."""

from __future__ import annotations

import numpy as np

from core.effects.change_points import change_points


def test_the_first_change_point_is_where_the_mean_jumps() -> None:
    rng = np.random.default_rng(6)
    series = rng.standard_normal((1000, 6))
    series[617:] += [0.5, 0, -0.4, 0, 0, 0.3]
    assert abs(change_points(series, count=3, apart=30)[0] - 617) <= 10


def test_a_jump_is_found_in_a_series_that_wanders() -> None:
    t = np.arange(2000)
    series = 5 * np.sin(t / 200)[:, None] + np.random.default_rng(8).standard_normal((2000, 2))
    series[1300:, 1] += 4.0
    assert min(abs(row - 1300) for row in change_points(series, count=4, apart=40)) <= 3


def test_a_series_too_short_to_tell_has_no_change_points() -> None:
    assert change_points(np.zeros((5, 6)), count=3, apart=2) == []
