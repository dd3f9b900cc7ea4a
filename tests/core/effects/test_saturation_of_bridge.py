"""A bridge at its end, against NumPy's clip of one of six gauges whose readings become a wrench by a matrix."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from core.array import Array
from core.effects.channels import find_load_at_rest
from core.effects.saturation_of_bridge import SaturationOfBridge
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = replace(scene(), noise=NOISE)
EFFECT = SaturationOfBridge()
LOAD = find_load_at_rest(RUN.phi)
TO_GAUGES = np.random.default_rng(4).normal(size=(6, 6)) / LOAD
GAUGE = 2


def clip_gauge(end: float) -> Array:
    """(N, 6), N and N m, with one gauge that reads no more than `end`."""
    gauges = RUN.nominal @ TO_GAUGES.T
    gauges[:, GAUGE] = np.minimum(gauges[:, GAUGE], end)
    return np.asarray(gauges @ np.linalg.inv(TO_GAUGES).T)


def find_end(share: float) -> float:
    """Beyond which the gauge is in a share of the run."""
    return float(np.quantile(RUN.nominal @ TO_GAUGES[GAUGE], 1.0 - share))


def test_it_is_what_a_clipped_gauge_does_to_the_wrench() -> None:
    end = find_end(0.3)
    size = float(np.linalg.norm(TO_GAUGES[GAUGE] * LOAD))
    lost = np.linalg.inv(TO_GAUGES)[:, GAUGE] / LOAD
    theta = np.concatenate((TO_GAUGES[GAUGE] * LOAD / size, [end / size], size * lost))
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta), clip_gauge(end), atol=1e-9 * float(np.abs(RUN.nominal).max()))


def test_a_fit_from_its_start_finds_the_gauge() -> None:
    wanted = clip_gauge(find_end(0.3))
    (start,) = EFFECT.starts(RUN, (wanted - RUN.nominal) / NOISE)
    fit = least_squares(lambda x: ((EFFECT.wrench(RUN, RUN.nominal, x) - wanted) / NOISE).ravel(), start)
    before = float(np.square((RUN.nominal - wanted) / NOISE).sum())
    assert 2.0 * fit.cost < 1e-4 * before
    across, along = np.outer(fit.x[:6], TO_GAUGES[GAUGE] * LOAD), float(fit.x[:6] @ (TO_GAUGES[GAUGE] * LOAD))
    assert along / (np.linalg.norm(fit.x[:6]) * np.linalg.norm(TO_GAUGES[GAUGE] * LOAD)) == pytest.approx(1.0, abs=0.01)
    np.testing.assert_allclose(across, across.T, atol=0.1 * float(np.abs(across).max()))


def test_what_lies_along_several_directions_or_is_small_has_no_start() -> None:
    rng = np.random.default_rng(5)
    assert EFFECT.starts(RUN, 100.0 * rng.normal(size=RUN.nominal.shape)) == []
    assert EFFECT.starts(RUN, rng.normal(size=RUN.nominal.shape)) == []
    assert EFFECT.starts(replace(RUN, noise=None), 100.0 * np.ones_like(RUN.nominal)) == []


def test_the_advice_says_how_long_it_is_there_and_where_most_is_lost() -> None:
    theta = np.array([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -9.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.1])
    said = EFFECT.advice(RUN, theta)
    assert said.parameters["share"] == 1.0
    assert "fz" in said.text
