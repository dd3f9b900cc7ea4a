"""A delay that wanders, against SciPy's splines at instants that are drawn here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize_scalar

from core.array import Array
from core.effects.delay_that_wanders import KNOTS, DelayThatWanders
from core.effects.time_delay import TimeDelay
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = replace(scene(), noise=NOISE)
EFFECT = DelayThatWanders()
MEAN_S = 0.02


def draw_course(seed: int) -> Array:
    """(N,), s: back and forth about 20 ms, never in the same way."""
    swings = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, 3)[:, None] + 2.0 * np.pi * RUN.t / np.array([[4.7], [3.1], [7.9]])
    return np.asarray(MEAN_S + 0.004 * np.sin(swings).sum(axis=0))


def come_late(late: Array) -> Array:
    """(N, 6), the nominal wrench of so much earlier."""
    return CubicSpline(RUN.t, RUN.nominal)(np.maximum(RUN.t - late, RUN.t[0]))


def left_by(late: Array, mean: float) -> Array:
    """(N, 6), what a constant delay leaves of one, in standard deviations of the noise."""
    return np.asarray((come_late(late) - come_late(np.full(len(RUN), mean))) / NOISE)


def test_the_wrench_is_as_late_as_the_course_says_in_each_row() -> None:
    at = max(1.0, (RUN.t[-1] - RUN.t[0]) / KNOTS) * np.arange(KNOTS + 1)
    levels = np.interp(RUN.t[0] + at, RUN.t, draw_course(0))
    theta = np.concatenate((levels[:1], np.diff(levels)))
    expected, settled = come_late(np.interp(RUN.t - RUN.t[0], at, levels)), RUN.t > RUN.t[0] + 0.2
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta)[settled], expected[settled], atol=2e-3)


def test_what_a_constant_delay_leaves_of_one_that_wanders_is_a_sign_of_it() -> None:
    for seed in (1, 2, 3):
        late = draw_course(seed)
        plain = minimize_scalar(lambda mean, late=late: np.square(left_by(late, mean)).sum(), bounds=(0.0, 0.1), method="bounded").x
        assert len(EFFECT.starts_beside(RUN, left_by(late, plain), np.array([plain]))) == 1


def test_noise_and_a_clock_that_slips_evenly_are_none() -> None:
    noise = np.random.default_rng(1).normal(size=RUN.nominal.shape)
    slipping = MEAN_S + 0.02 * ((RUN.t - RUN.t[0]) / 3.7 % 1.0 - 0.5)
    for residual in (noise, left_by(slipping, MEAN_S), 0.1 * RUN.nominal / NOISE):
        assert EFFECT.starts_beside(RUN, residual, np.array([MEAN_S])) == []
    assert EFFECT.starts(RUN, noise) == []


def test_without_changes_it_is_the_constant_delay() -> None:
    theta = np.array([0.023, *np.zeros(KNOTS)])
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta), TimeDelay().wrench(RUN, RUN.nominal, theta[:1]), atol=1e-9)


def test_the_advice_tells_from_which_to_which_delay_it_goes() -> None:
    theta = np.array([0.02, 0.01, -0.025, *np.zeros(KNOTS - 2)])
    assert "between 5.0 and 30.0 ms" in EFFECT.advice(RUN, theta).text
