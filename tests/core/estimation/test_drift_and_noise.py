"""Noise from the holds, and how fast the offset can walk at most."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.noise import correlation_time, sensor_noise
from core.estimation.segments import Segment


@pytest.mark.parametrize("rho", [0.0, 0.6])
def test_noise_and_its_correlation_come_from_the_holds_despite_a_drift_and_one_disturbed_hold(rho: float) -> None:
    rng = np.random.default_rng(1)
    n, std = 12_000, np.array([0.05, 0.05, 0.07, 0.003, 0.003, 0.003])
    x = np.zeros((n, 6))
    innovations = rng.normal(size=(n, 6)) * np.sqrt(1 - rho**2)
    for k in range(1, n):
        x[k] = rho * x[k - 1] + innovations[k]
    wrench = x * std + np.linspace(0, 1, n)[:, None]
    wrench[:2000] += np.sin(np.arange(2000) / 30.0)[:, None]
    parts = tuple(Segment(k, k + 2000, "hold:free") for k in range(0, n, 2000))
    noise = sensor_noise(0.002 * np.arange(n), wrench, np.ones(n, dtype=bool), parts)
    assert noise is not None and noise.measured
    np.testing.assert_allclose(noise.std, std, rtol=0.06)
    np.testing.assert_allclose(noise.long_run, (1 + rho) / (1 - rho), rtol=0.2)


def test_without_a_hold_the_nominal_noise_counts_and_without_that_nothing_is_known() -> None:
    t, wrench, parts = 0.002 * np.arange(100), np.zeros((100, 6)), (Segment(0, 100, "transfer"),)
    nominal = sensor_noise(t, wrench, np.zeros(100, dtype=bool), parts, nominal_std=np.ones(6))
    assert nominal is not None and not nominal.measured
    assert sensor_noise(t, wrench, np.zeros(100, dtype=bool), parts) is None


def test_white_residuals_have_a_correlation_time_of_one() -> None:
    rng = np.random.default_rng(0)
    r = rng.normal(size=4000)
    assert correlation_time(r) == pytest.approx(1.0, abs=0.1)
    assert correlation_time(np.convolve(r, np.ones(10), "valid")) == pytest.approx(10.0, rel=0.15)
