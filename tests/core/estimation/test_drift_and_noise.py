"""Drift as a random walk, noise from the holds."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.drift import drift_basis, improve_variance, parts_of, steps_between
from core.estimation.noise import correlation_time, sensor_noise
from core.estimation.segments import Segment


def test_the_basis_has_no_mean_and_can_be_a_straight_line() -> None:
    t = np.linspace(0.0, 60.0, 600)
    ramps = drift_basis(t, [(0.0, 60.0)])
    np.testing.assert_allclose(ramps.mean(axis=0), 0.0, atol=1e-12)
    np.testing.assert_allclose(ramps.sum(axis=1), (t - t.mean()) / 6.0, atol=1e-9)
    assert drift_basis(t[:20], [(0.0, 2.0)]).shape == (20, 0)


def test_across_a_pause_the_walk_rests_and_the_offset_may_jump() -> None:
    t = np.concatenate((np.arange(0.0, 24.0, 0.1), np.arange(84.0, 120.0, 0.1)))
    parts = parts_of(t)
    np.testing.assert_allclose(parts, [(0.0, 23.9), (84.0, 119.9)])
    ramps, steps = drift_basis(t, parts), steps_between(t, parts)
    assert ramps.shape[1] == 4 + 6
    assert np.linalg.matrix_rank(np.column_stack((ramps, steps, np.ones(len(t))))) == 12
    np.testing.assert_allclose(steps[:, 0], np.where(t > 50.0, 1.0, 0.0) - np.mean(t > 50.0))
    assert steps_between(t[:200], parts).shape == (200, 0)


def test_the_walks_strength_is_found() -> None:
    rng = np.random.default_rng(0)
    truth = 0.05
    t = np.linspace(0.0, 240.0, 4000)
    ramps = drift_basis(t, [(0.0, 240.0)])
    z = truth * rng.normal(size=ramps.shape[1])
    y = ramps @ z + 0.05 * rng.normal(size=len(t))
    variance = 1e-4
    for _ in range(40):
        covariance = np.linalg.inv(ramps.T @ ramps / 0.05**2 + np.eye(len(z)) / variance)
        variance = improve_variance(variance, covariance @ ramps.T @ y / 0.05**2, covariance, 1e-12)
    assert np.sqrt(variance) == pytest.approx(truth, rel=0.3)


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
    noise = sensor_noise(wrench, np.ones(n, dtype=bool), parts)
    assert noise is not None and noise.measured
    np.testing.assert_allclose(noise.std, std, rtol=0.06)
    np.testing.assert_allclose(noise.long_run, (1 + rho) / (1 - rho), rtol=0.2)


def test_without_a_hold_the_nominal_noise_counts_and_without_that_nothing_is_known() -> None:
    wrench, parts = np.zeros((100, 6)), (Segment(0, 100, "transfer"),)
    nominal = sensor_noise(wrench, np.zeros(100, dtype=bool), parts, nominal_std=np.ones(6))
    assert nominal is not None and not nominal.measured
    assert sensor_noise(wrench, np.zeros(100, dtype=bool), parts) is None


def test_white_residuals_have_a_correlation_time_of_one() -> None:
    rng = np.random.default_rng(0)
    r = rng.normal(size=4000)
    assert correlation_time(r) == pytest.approx(1.0, abs=0.1)
    assert correlation_time(np.convolve(r, np.ones(10), "valid")) == pytest.approx(10.0, rel=0.15)
