"""Noise from the holds: what it says of a single sample against how means over many samples scatter."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter

from core.estimation.noise import sensor_noise
from core.estimation.segments import Segment

STD = np.array([0.05, 0.05, 0.07, 0.003, 0.003, 0.003])


def correlated(rng: np.random.Generator, count: int, rho: float) -> np.ndarray:
    """(count, 6), of unit variance; each sample keeps `rho` of the one before."""
    fresh = rng.normal(size=(count, 6)) * np.sqrt(1.0 - rho**2)
    fresh[0] /= np.sqrt(1.0 - rho**2)
    return np.asarray(lfilter([1.0], [1.0, -rho], fresh, axis=0))


@pytest.mark.parametrize("rho", [0.0, 0.6, 0.9])
def test_means_over_many_samples_scatter_as_the_variance_of_a_sample_says(rho: float) -> None:
    """At 0.9 they scatter 4.4 times as widely as those of white noise would."""
    rng = np.random.default_rng(3)
    holds = tuple(Segment(k, k + 2000, "hold:free") for k in range(0, 40_000, 2000))
    noise = sensor_noise(0.002 * np.arange(40_000), STD * correlated(rng, 40_000, rho), np.ones(40_000, dtype=bool), holds)
    assert noise is not None
    means = (STD * correlated(rng, 400_000, rho)).reshape(-1, 500, 6).mean(axis=1)
    np.testing.assert_allclose(noise.variance, 500 * means.var(axis=0), rtol=0.25)


@pytest.mark.parametrize("rate", [0.0, 0.3])
def test_the_holds_bound_the_walk_above_its_rate_and_not_far_above_one_disturbed_hold_aside(rate: float) -> None:
    n, each, t = 30_000, 1500, 0.002 * np.arange(30_000)
    holds = tuple(Segment(k, k + each, "hold:free") for k in range(0, n, each))
    for seed in range(10):
        rng = np.random.default_rng(seed)
        walk = np.cumsum(rate * np.sqrt(0.002) * rng.normal(size=(n, 6)), axis=0)
        walk[:each] += np.linspace(0.0, 50.0, each)[:, None]
        noise = sensor_noise(t, STD * (walk + rng.normal(size=(n, 6))), np.ones(n, dtype=bool), holds)
        assert noise is not None
        bound = np.sqrt(noise.fastest_walk) / STD
        assert (bound > rate).all() and (bound < 0.4 + 2.5 * rate).all()


def test_where_no_hold_shows_a_walk_the_stated_noise_bounds_it() -> None:
    nothing = np.zeros(100, dtype=bool)
    noise = sensor_noise(0.002 * np.arange(100), np.zeros((100, 6)), nothing, (Segment(0, 100, "transfer"),), nominal_std=STD)
    assert noise is not None
    np.testing.assert_allclose(noise.fastest_walk, (2.0 * STD) ** 2)
