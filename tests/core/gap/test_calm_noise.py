"""Noise of a reading where something else goes on in the holds."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter

from core.estimation.noise import sensor_noise
from core.estimation.segments import Segment
from core.gap.calm_noise import find_noise

Array = np.ndarray
PERIOD, STATED = 0.004, np.full(6, 0.05)
T = PERIOD * np.arange(10_000)
HOLDS = tuple(Segment(k, k + 500, "hold:x+" if (k // 500) % 2 else "transfer") for k in range(0, len(T), 500))
STILL = np.ones(len(T), dtype=bool)


def noise(slow: Array | float = 0.0, factor: float = 1.0) -> Array:
    """White noise of a factor times what is stated, and something slow (N,) in all channels."""
    white = factor * STATED * np.random.default_rng(2).normal(size=(len(T), 6))
    return white + np.multiply.outer(np.broadcast_to(slow, len(T)), np.ones(6))


def test_white_noise_is_what_it_is_however_much_is_stated() -> None:
    for factor in (0.5, 1.0, 4.0):
        assert find_noise(T, noise(0.0, factor), STILL, HOLDS, nominal_std=STATED).std == pytest.approx(factor * STATED, rel=0.05)


def test_air_that_blows_on_and_off_in_the_holds_is_no_noise() -> None:
    blown = lfilter([0.04], [1.0, -0.96], 1.5 * (np.floor(T / 1.7) % 2))
    found = find_noise(T, noise(blown), STILL, HOLDS, nominal_std=STATED)
    swallowed = sensor_noise(T, noise(blown), STILL, HOLDS, nominal_std=STATED)
    assert np.sqrt(found.variance) == pytest.approx(STATED, rel=0.8)
    assert (np.sqrt(swallowed.variance) > 20.0 * STATED).all()


def test_noise_that_is_correlated_over_some_samples_stays_noise() -> None:
    coloured = lfilter([np.sqrt(1 - 0.6**2)], [1.0, -0.6], np.random.default_rng(3).normal(size=(len(T), 6)), axis=0) * 0.15
    found, whole = (find(T, coloured, STILL, HOLDS, nominal_std=STATED) for find in (find_noise, sensor_noise))
    assert found.variance == pytest.approx(whole.variance)


def test_where_nothing_is_stated_all_that_is_in_the_holds_is_noise() -> None:
    blown = lfilter([0.04], [1.0, -0.96], 1.5 * (np.floor(T / 1.7) % 2))
    found, whole = find_noise(T, noise(blown), STILL, HOLDS), sensor_noise(T, noise(blown), STILL, HOLDS)
    assert found.variance == pytest.approx(whole.variance)


def test_what_rings_after_each_stop_and_dies_down_is_no_noise() -> None:
    since = T % (500 * PERIOD)
    rung = 3.0 * np.exp(-since / 0.3) * np.sin(2 * np.pi * 11.0 * since)
    found = find_noise(T, noise(rung), STILL, HOLDS, nominal_std=STATED)
    swallowed = sensor_noise(T, noise(rung), STILL, HOLDS, nominal_std=STATED)
    assert np.sqrt(found.variance) == pytest.approx(STATED, rel=0.3)
    assert (np.sqrt(swallowed.variance) > 20.0 * STATED).all()
