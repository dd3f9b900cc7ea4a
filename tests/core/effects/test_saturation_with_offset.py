"""A channel that is clipped together with its offset, against NumPy's clip of the sum of both."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import least_squares

from core.array import Array
from core.effects.saturation_with_offset import SaturationWithOffset
from core.effects.sensor_saturation import SensorSaturation
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = replace(scene(), noise=NOISE)
EFFECT = SaturationWithOffset()
FY = 1


def find_low_limit() -> float:
    """N, so low that the channel is clipped before its load is zero."""
    load = RUN.nominal[:, FY]
    return float(min(np.quantile(load, 0.75), -0.05 * np.ptp(load)))


def clip_with_offset(limit: float) -> Array:
    """(N, 6), with an offset of 40 N in one channel, whose range ends so that the load alone is clipped at `limit`; the offset is taken off
    again."""
    W, offset = RUN.nominal.copy(), -40.0
    W[:, FY] = np.minimum(W[:, FY] + offset, limit + offset) - offset
    return W


def test_a_fit_from_what_was_found_before_it_finds_a_limit_below_zero() -> None:
    limit, absent = find_low_limit(), np.array([p.absent for p in EFFECT.parameters(RUN)])
    wanted = clip_with_offset(limit)
    assert limit < 0.0
    (start,) = EFFECT.starts(RUN, (wanted - RUN.nominal) / NOISE)
    assert start[FY] < absent[FY]

    def left(x: Array) -> Array:
        theta = absent.copy()
        theta[FY] = x[0]
        return np.asarray((EFFECT.wrench(RUN, RUN.nominal, theta) - wanted)[:, FY])

    assert abs(least_squares(left, start[[FY]]).x[0] - limit) < 1e-6
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, np.where(np.arange(12) == FY, limit, absent)), wanted, atol=1e-12)


def test_the_plain_shape_has_no_such_limit() -> None:
    theta = np.array([p.absent for p in SensorSaturation().parameters(RUN)])
    theta[FY] = SensorSaturation().parameters(RUN)[FY].upper
    assert SensorSaturation().wrench(RUN, RUN.nominal, theta)[:, FY].max() > 0.0 > find_low_limit()


def test_noise_and_what_goes_with_the_load_start_none() -> None:
    noise = np.random.default_rng(1).normal(size=RUN.nominal.shape)
    assert EFFECT.starts(RUN, noise) == []
    assert EFFECT.starts(RUN, noise + 20.0 * np.sin(RUN.t)[:, None]) == []


def test_the_advice_tells_the_limit() -> None:
    theta = np.array([p.absent for p in EFFECT.parameters(RUN)])
    theta[FY] = -3.5
    assert "-3.5 N" in EFFECT.advice(RUN, theta).text.replace("\u2212", "-")
