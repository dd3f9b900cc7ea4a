"""The search for gear ripple, on angles and responses written down by hand."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.gear_search import COARSEST, FINEST, RippleSearch

RATIO = 80.0


def turned_by(range_rad: float) -> tuple[RippleSearch, np.ndarray]:
    """A joint that turns slowly to and fro, and the residual (N, 6) of a ripple with two waves per turn of an 80:1 gear."""
    t = np.linspace(0.0, 20.0, 4000)
    angle, speed = 0.5 * range_rad * np.sin(t), 0.5 * range_rad * np.cos(t)
    response = np.tile([1.0, 0.5, 0.0, 0.0, 0.2, 0.0], (len(t), 1))
    return RippleSearch(angle, speed, response, fastest=1e3), 0.1 * np.cos(2.0 * RATIO * angle)[:, None] * response


@pytest.mark.parametrize("range_rad", [2.0, 0.5])
def test_the_ratio_of_a_ripple_is_found_to_what_the_range_resolves(range_rad: float) -> None:
    search, residual = turned_by(range_rad)
    assert search.peak(residual).ratio == pytest.approx(RATIO, abs=np.pi / range_rad)


@pytest.mark.parametrize("range_rad", [0.1, 1e-3, 0.0])
def test_a_joint_that_hardly_turns_has_a_peak_within_the_searched_ratios_too(range_rad: float) -> None:
    search, residual = turned_by(range_rad)
    assert COARSEST <= search.peak(residual).ratio < FINEST
