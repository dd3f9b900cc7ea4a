"""A filter that opens, against SciPy's integration of its equation."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

from core.array import Array
from core.effects.lowpass_that_opens import LowpassThatOpens
from core.effects.sensor_lowpass import SensorLowpass
from tests.core.effects.synthetic_scene import GRAVITY, NOISE, PAYLOAD, scene

RUN = scene(rate=500.0)
EFFECT = LowpassThatOpens()
ABOUT = np.abs(PAYLOAD[1:4])
LOAD = -GRAVITY[2] * np.array([*[PAYLOAD[0]] * 3, *(float(np.hypot(*np.delete(ABOUT, k))) for k in range(3))])
"""Of the payload in each channel, at rest, N and N m."""


def opened(tau: float, opening: Array) -> Array:
    """(N, 6), the solution of `tau y' = (1 + a |w - y| / L) (w - y)`."""
    t, w = RUN.t - RUN.t[0], RUN.nominal
    spline = CubicSpline(t, w)

    def rate(now: float, y: Array) -> Array:
        away = spline(now) - y
        return np.asarray((1.0 + opening * np.abs(away) / LOAD) * away / tau)

    return np.asarray(solve_ivp(rate, (t[0], t[-1]), w[0], t_eval=t, rtol=1e-8, atol=1e-8, max_step=0.02).y.T)


@pytest.mark.parametrize(("tau", "opening"), [(0.05, 10.0), (0.1, 40.0)])
def test_it_follows_the_faster_the_further_it_is_away(tau: float, opening: float) -> None:
    planted = opened(tau, np.full(6, opening))
    found = EFFECT.wrench(RUN, RUN.nominal, np.array([tau, *[opening] * 6]))
    lag = np.abs(planted - RUN.nominal).max(axis=0)
    assert (np.abs(found - planted).max(axis=0) < 0.02 * lag).all()
    plain = SensorLowpass().wrench(RUN, RUN.nominal, np.array([tau, 0.0]))
    assert (np.abs(plain - planted).max(axis=0) > 0.2 * lag).all()


def test_a_fit_beside_the_plain_filter_finds_how_it_opens() -> None:
    change = opened(0.08, np.array([10.0, 20.0, 15.0, 10.0, 30.0, 20.0])) - RUN.nominal

    def left(x: Array) -> Array:
        return np.asarray(((EFFECT.wrench(RUN, RUN.nominal, x) - RUN.nominal - change) / NOISE).ravel())

    assert EFFECT.starts(RUN, change / NOISE) == []
    scale = np.array([p.scale for p in EFFECT.parameters(RUN)])
    starts = EFFECT.starts_beside(RUN, change / NOISE, np.array([0.04, 0.0]))
    fit = min((least_squares(left, start, bounds=(0.0, np.inf), x_scale=scale) for start in starts), key=lambda each: each.cost)
    assert fit.x[0] == pytest.approx(0.08, rel=0.02)
    np.testing.assert_allclose(fit.x[1:], [10.0, 20.0, 15.0, 10.0, 30.0, 20.0], rtol=0.05)


def test_the_advice_has_the_corner_at_rest() -> None:
    assert "above 3 Hz" in EFFECT.advice(RUN, np.array([0.05, *[20.0] * 6])).text
