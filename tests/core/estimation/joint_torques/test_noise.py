"""`core.estimation.joint_torques.noise` against the covariance written out."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.joint_torques.noise import TorqueNoise, whiten_torques


def test_innovations_and_determinant_are_those_of_the_covariance_written_out() -> None:
    rng = np.random.default_rng(0)
    t = np.concatenate((np.sort(rng.uniform(0.0, 4.0, 30)), np.sort(rng.uniform(0.0, 4.0, 20))))
    noise = TorqueNoise(0.3, 0.8, 0.7)
    C = 0.09 * np.eye(50) + 0.64 * np.exp(-np.abs(t[:, None] - t) / 0.7)
    C[:30, 30:] = C[30:, :30] = 0.0  # the second series knows nothing of the first
    y = rng.normal(size=(50, 3))
    white, half = whiten_torques(y, t, noise)
    np.testing.assert_allclose(white.T @ white, y.T @ np.linalg.solve(C, y), rtol=1e-9)
    assert half == pytest.approx(0.5 * np.linalg.slogdet(C)[1])


def test_what_the_search_starts_from_is_the_noise_that_it_stands_for() -> None:
    noise = TorqueNoise.of_logarithms(np.log([0.2, 0.3, 1.5])).with_floor(0.01)
    again = TorqueNoise.of_logarithms(noise.to_logarithms(0.01)).with_floor(0.01)
    assert (again.white, again.lasting, again.time_s) == pytest.approx((noise.white, noise.lasting, noise.time_s))
