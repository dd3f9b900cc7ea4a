"""Eq. (8)-(10)."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.uncertainty import gain, inertia_uncertainty, one_sigma, propagate_covariance


def test_eq_8_adds_the_information_of_each_sample() -> None:
    rng = np.random.default_rng(0)
    variance = np.array([1e-3, 2e-3, 3e-3])
    S = np.eye(3) * 10.0
    information = np.linalg.inv(S)
    for _ in range(20):
        r = rng.normal(size=(3, 3))
        S = propagate_covariance(S, r, gain(S, r, variance))
        information += r.T @ np.diag(1 / variance) @ r
    np.testing.assert_allclose(S, np.linalg.inv(information), rtol=1e-8)
    np.testing.assert_allclose(one_sigma(S) ** 2, np.diag(S))


def test_eq_8_for_the_mass_is_the_variance_of_a_mean() -> None:
    S = np.array([[1e6]])
    r, variance = -np.array([[9.81], [0.0], [0.0]]), np.full(3, 0.0548**2)
    for _ in range(400):
        S = propagate_covariance(S, r, gain(S, r, variance))
    assert float(one_sigma(S)[0]) == pytest.approx(0.0548 / 9.81 / 20.0, rel=1e-5)


def test_eq_10_adds_the_relative_uncertainties_of_torque_and_acceleration() -> None:
    # steel block, Table 2: hypot(2.81e-3 / (6.928e-3 4.8), 0.0332 / 4.8) = 8.5 %; the paper's Table 3 prints 3.7 %
    value = inertia_uncertainty(6.928e-3, torque_std=7.9e-6**0.5, alpha_std=1.1e-3**0.5, alpha_reference=4.8)
    assert value == pytest.approx(5.9e-4, rel=0.02)
