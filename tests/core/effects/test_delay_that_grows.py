"""A delay that grows, against SciPy's splines at instants that are written down here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares, minimize_scalar

from core.array import Array
from core.effects.delay_that_grows import DelayThatGrows
from core.effects.time_delay import TimeDelay
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = replace(scene(), noise=NOISE)
LONG_S = float(RUN.t[-1] - RUN.t[0])
EFFECT = DelayThatGrows()


def come_late(late: Array) -> Array:
    """(N, 6), the nominal wrench of so much earlier."""
    return CubicSpline(RUN.t, RUN.nominal)(np.maximum(RUN.t - late, RUN.t[0]))


def slipping(mean: float, swing: float, cycle: float) -> Array:
    """(N,), s: a sawtooth about its mean, begun with its shortest delay."""
    return mean + swing * ((RUN.t - RUN.t[0]) / cycle % 1.0 - 0.5)


def test_a_buffer_that_slips_takes_the_delay_back() -> None:
    theta = np.array([0.03, 0.02 / 3.0, 3.0, RUN.t[0] + 3.0])
    settled = RUN.t > RUN.t[0] + 0.2
    expected = come_late(slipping(0.03, 0.02, 3.0))
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta)[settled], expected[settled], atol=2e-3)


def left_by(late: Array, mean: float) -> Array:
    """(N, 6), what a constant delay leaves of one, in standard deviations of the noise."""
    return (come_late(late) - come_late(np.full(len(RUN), mean))) / NOISE


@pytest.mark.parametrize(("cycle", "mean"), [(3.7, 0.02), (2.3, 0.06), (5.2, 0.02)])
def test_the_search_before_the_fit_finds_from_slip_to_slip_and_which_way_it_grows(cycle: float, mean: float) -> None:
    ((delay, growth, found, slip),) = EFFECT.starts_beside(RUN, left_by(slipping(mean, 0.02, cycle), mean), np.array([mean]))
    assert delay == mean
    assert found == pytest.approx(cycle, rel=0.05)
    assert abs((slip - RUN.t[0] + 0.5 * cycle) % cycle - 0.5 * cycle) < 0.5
    assert growth > 0.0
    ((_, shrinks, _, _),) = EFFECT.starts_beside(RUN, left_by(slipping(mean, -0.02, cycle), mean), np.array([mean]))
    assert shrinks < 0.0


def test_a_fit_finds_how_much_later_a_clock_is_that_runs_slow() -> None:
    late = 0.03 * (RUN.t - RUN.t[0]) / LONG_S
    change = come_late(late) - RUN.nominal
    scale = np.array([p.scale for p in EFFECT.parameters(RUN)])

    def left(x: Array) -> Array:
        return np.asarray(((EFFECT.wrench(RUN, RUN.nominal, x) - RUN.nominal - change) / NOISE).ravel())

    plain = minimize_scalar(lambda mean: np.square(left_by(late, mean)).sum(), bounds=(0.0, 0.03), method="bounded").x
    (start,) = EFFECT.starts_beside(RUN, left_by(late, plain), np.array([plain]))
    fit = least_squares(left, start, x_scale=scale)
    assert 2.0 * fit.cost < 0.01 * np.square(change / NOISE).sum()
    assert fit.x[1] == pytest.approx(0.03 / LONG_S, rel=0.05)


def test_what_noise_leaves_of_a_constant_delay_is_no_sign_of_one_that_grows() -> None:
    noise = np.random.default_rng(1).normal(size=RUN.nominal.shape)
    assert EFFECT.starts_beside(RUN, noise, np.array([0.02])) == []
    assert EFFECT.starts(RUN, noise) == []


def test_with_no_growth_it_is_the_constant_delay() -> None:
    absent = np.array([p.absent for p in EFFECT.parameters(RUN)])
    absent[0] = 0.023
    expected = TimeDelay().wrench(RUN, RUN.nominal, np.array([0.023]))
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, absent), expected, atol=1e-9)


def test_the_advice_says_how_it_grows_and_when_it_slips() -> None:
    grows, slips = (EFFECT.advice(RUN, np.array([0.02, 0.0005, cycle, RUN.t[0]])).text for cycle in (3.0 * LONG_S, 4.0))
    assert "30.0 ms later" in grows
    assert "every 4.0 s" in slips
