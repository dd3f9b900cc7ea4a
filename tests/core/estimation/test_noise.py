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
    noise = sensor_noise(STD * correlated(rng, 40_000, rho), np.ones(40_000, dtype=bool), holds)
    assert noise is not None
    means = (STD * correlated(rng, 400_000, rho)).reshape(-1, 500, 6).mean(axis=1)
    np.testing.assert_allclose(noise.variance, 500 * means.var(axis=0), rtol=0.25)
