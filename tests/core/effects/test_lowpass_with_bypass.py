"""A filter with a bypass, against SciPy's simulation of the transfer function."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.signal import lsim

from core.array import Array
from core.effects.lowpass_with_bypass import LowpassWithBypass
from core.effects.sensor_lowpass import SensorLowpass
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = scene()
EFFECT = LowpassWithBypass()


def filtered(tau: float, direct: float) -> Array:
    """(N, 6), `(1 + d tau s) / (1 + tau s)` of each channel, at rest at its first value before."""
    t, w = RUN.t - RUN.t[0], RUN.nominal
    system = ([direct * tau, 1.0], [tau, 1.0])
    return np.column_stack([lsim(system, channel - channel[0], t)[1] + channel[0] for channel in w.T])


@pytest.mark.parametrize(("tau", "direct"), [(0.05, 0.3), (0.12, 0.7), (0.02, 0.05)])
def test_it_is_a_lead_beside_a_lag(tau: float, direct: float) -> None:
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, np.array([tau, direct])), filtered(tau, direct), atol=1e-6)


def test_without_a_bypass_it_is_the_plain_filter() -> None:
    plain = SensorLowpass().wrench(RUN, RUN.nominal, np.array([0.04, 0.0]))
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, np.array([0.04, 0.0])), plain, atol=1e-12)


def test_a_fit_beside_the_plain_filter_finds_what_goes_round() -> None:
    change = filtered(0.06, 0.4) - RUN.nominal
    lower, upper, scale = (np.array([getattr(p, name) for p in EFFECT.parameters(RUN)]) for name in ("lower", "upper", "scale"))

    def left(x: Array) -> Array:
        return np.asarray(((EFFECT.wrench(RUN, RUN.nominal, x) - RUN.nominal - change) / NOISE).ravel())

    assert EFFECT.starts(RUN, change / NOISE) == []
    for start in EFFECT.starts_beside(RUN, change / NOISE, np.array([0.036, 0.0])):
        fit = least_squares(left, start, bounds=(lower - 1e-9, upper), x_scale=scale)
        np.testing.assert_allclose(fit.x, [0.06, 0.4], rtol=1e-3)


def test_the_advice_has_the_corner_and_how_late_slow_signals_are() -> None:
    said = EFFECT.advice(RUN, np.array([0.05, 0.4])).text
    assert "above 3 Hz" in said
    assert "30 ms" in said
