"""Bridges at their ends, against NumPy's clip of one or two of six gauges whose readings become a wrench by a matrix."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from core.array import Array
from core.effects.channels import find_load_at_rest
from core.effects.parameter_title import find_title
from core.effects.saturation_of_bridge import EACH, SaturationOfBridge
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = replace(scene(), noise=NOISE)
EFFECT = SaturationOfBridge()
LOAD = find_load_at_rest(RUN.phi)
TO_GAUGES = np.random.default_rng(4).normal(size=(6, 6)) / LOAD
GAUGE, OTHER = 2, 5

Ends = dict[int, tuple[float, float]]


def clip_gauges(ends: Ends) -> Array:
    """(N, 6), N and N m, with gauges that read no less and no more than their ends."""
    gauges = RUN.nominal @ TO_GAUGES.T
    for gauge, (least, most) in ends.items():
        gauges[:, gauge] = np.clip(gauges[:, gauge], least, most)
    return np.asarray(gauges @ np.linalg.inv(TO_GAUGES).T)


def find_ends(gauge: int, below: float, above: float) -> tuple[float, float]:
    """Beyond which the gauge is in these shares of the run."""
    least, most = np.quantile(RUN.nominal @ TO_GAUGES[gauge], (below, 1.0 - above))
    return float(least), float(most)


def describe(ends: Ends) -> Array:
    """The effect's parameters of these gauges."""
    back, theta = np.linalg.inv(TO_GAUGES), np.zeros((2, EACH))
    for row, (gauge, (least, most)) in zip(theta, ends.items(), strict=False):
        size = float(np.linalg.norm(TO_GAUGES[gauge] * LOAD))
        row[:] = *(TO_GAUGES[gauge] * LOAD / size), most / size, least / size, *(size * back[:, gauge] / LOAD)
    return theta.ravel()


ENDS = [
    pytest.param({GAUGE: find_ends(GAUGE, 0.0, 0.3)}, id="one end of one bridge"),
    pytest.param({GAUGE: find_ends(GAUGE, 0.2, 0.15)}, id="both ends of one bridge"),
    pytest.param({GAUGE: find_ends(GAUGE, 0.1, 0.15), OTHER: find_ends(OTHER, 0.15, 0.1)}, id="both ends of two bridges"),
]


@pytest.mark.parametrize("ends", ENDS)
def test_it_is_what_clipped_gauges_do_to_the_wrench(ends: Ends) -> None:
    found, size = EFFECT.wrench(RUN, RUN.nominal, describe(ends)), float(np.abs(RUN.nominal).max())
    np.testing.assert_allclose(found, clip_gauges(ends), atol=1e-9 * size)
    assert np.abs(found - RUN.nominal).max() > 1e-3 * size


@pytest.mark.parametrize("ends", ENDS)
def test_a_fit_from_its_start_finds_the_gauges(ends: Ends) -> None:
    wanted = clip_gauges(ends)
    (start,) = EFFECT.starts(RUN, (wanted - RUN.nominal) / NOISE)
    fit = least_squares(lambda x: ((EFFECT.wrench(RUN, RUN.nominal, x) - wanted) / NOISE).ravel(), start)
    before = float(np.square((RUN.nominal - wanted) / NOISE).sum())
    assert 2.0 * fit.cost < 1e-4 * before
    found = start.reshape(-1, EACH).any(axis=1)
    assert found.sum() == len(ends)
    read = RUN.nominal / LOAD @ fit.x.reshape(-1, EACH)[found, :6].T
    for gauge in ends:
        alike = [abs(np.corrcoef(each, RUN.nominal @ TO_GAUGES[gauge])[0, 1]) for each in read.T]
        assert max(alike) > 0.999


def test_one_bridge_is_the_smaller_shape() -> None:
    numbers, one = [p.name.split("_")[1] for p in EFFECT.parameters(RUN)], EFFECT.smaller_shape(RUN)
    assert (set(numbers[:one]), set(numbers[one:])) == ({"1"}, {"2"})
    assert [find_title(f"bridge_2_{name}").text for name in ("fx_share", "upper_limit_share", "lost_tz_share")] == [
        "bridge 2 fx",
        "bridge 2 upper limit",
        "bridge 2 lost tz",
    ]


def test_what_lies_along_many_directions_or_is_small_has_no_start() -> None:
    rng = np.random.default_rng(5)
    assert EFFECT.starts(RUN, 100.0 * rng.normal(size=RUN.nominal.shape)) == []
    assert EFFECT.starts(RUN, rng.normal(size=RUN.nominal.shape)) == []
    assert EFFECT.starts(replace(RUN, noise=None), 100.0 * np.ones_like(RUN.nominal)) == []


def test_the_advice_says_how_long_it_is_there_and_where_most_is_lost() -> None:
    theta = np.zeros(2 * EACH)
    theta[:EACH] = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -9.0, -9.0, 0.1, 0.0, 0.5, 0.0, 0.0, 0.0]
    said = EFFECT.advice(RUN, theta)
    assert said.parameters["share"] == 1.0
    assert "fz" in said.text
