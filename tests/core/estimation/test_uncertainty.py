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


@pytest.mark.parametrize(
    ("torque_std", "alpha_std"), [(1e-6, 0.3), (3e-3, 1e-5), (3e-3, 0.3)], ids=["acceleration alone", "torque alone", "both"]
)
def test_eq_10_is_how_torque_over_acceleration_answers_to_the_noise_of_each(torque_std: float, alpha_std: float) -> None:
    """The torque is the rate of the angular momentum of four point masses, all derivatives are differences."""
    masses, radius, phase = np.array([0.5, 0.3, 0.4, 0.6]), np.array([0.05, 0.08, 0.03, 0.06]), np.array([0.1, 1.7, 3.0, 4.4])
    alpha, now, h = 4.8, 0.2, 1e-3

    def places(t: float) -> np.ndarray:
        angle = phase + 0.5 * alpha * t**2
        return radius * np.array([np.cos(angle), np.sin(angle)])

    def angular_momentum(t: float) -> float:
        (x, y), (vx, vy) = places(t), (places(t + h) - places(t - h)) / (2.0 * h)
        return float(masses @ (x * vy - y * vx))

    torque = (angular_momentum(now + h) - angular_momentum(now - h)) / (2.0 * h)
    of_torque = ((torque + torque_std) / alpha - (torque - torque_std) / alpha) / 2.0
    small = 1e-3 * alpha_std
    of_alpha = alpha_std * (torque / (alpha + small) - torque / (alpha - small)) / (2.0 * small)
    stated = inertia_uncertainty(torque / alpha, torque_std=torque_std, alpha_std=alpha_std, alpha_reference=alpha)
    assert stated == pytest.approx(float(np.hypot(of_torque, of_alpha)), rel=1e-4)
    assert torque / alpha == pytest.approx(float(masses @ radius**2), rel=1e-4)
