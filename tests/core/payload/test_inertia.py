"""Eq. (1)-(2) and frame changes, with Pinocchio as the oracle."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.errors import BadPayload
from core.payload.inertia import (
    PINOCCHIO_ORDER,
    InertialParameters,
    Motion,
    frame_change,
    is_consistent,
    phi_of_pseudo_inertia,
    pseudo_inertia,
    regressor,
    six_of,
    symmetric,
)
from tests.synthetic import random_payload

seeds = st.integers(0, 2**32 - 1)


def random_motion(rng: np.random.Generator, count: int = 5) -> Motion:
    g = rng.normal(size=(count, 3))
    g *= 9.81 / np.linalg.norm(g, axis=1, keepdims=True)
    return Motion(g, *(scale * rng.normal(size=(count, 3)) for scale in (5.0, 2.0, 8.0)))


def oracle(motion: Motion, body: InertialParameters) -> np.ndarray:
    """Newton-Euler of a free body in Pinocchio: spatial inertia times spatial acceleration minus gravity, plus v x* h."""
    inertia = pin.Inertia.FromDynamicParameters(body.phi[PINOCCHIO_ORDER])
    rows = []
    for g, a, omega, alpha in zip(motion.g, motion.a, motion.omega, motion.alpha, strict=True):
        v = pin.Motion(np.zeros(3), omega)
        rows.append((inertia * pin.Motion(a - g, alpha) + v.cross(inertia * v)).vector)
    return np.array(rows)


@given(seeds)
def test_the_regressor_times_phi_is_newton_and_euler(seed: int) -> None:
    rng = np.random.default_rng(seed)
    body, motion = random_payload(rng), random_motion(rng)
    np.testing.assert_allclose(regressor(motion) @ body.phi, oracle(motion, body), rtol=1e-10, atol=1e-10)


@given(seeds)
def test_the_regressor_agrees_with_pinocchios_column_by_column(seed: int) -> None:
    motion = random_motion(np.random.default_rng(seed), 1)
    v, a = pin.Motion(np.zeros(3), motion.omega[0]), pin.Motion(motion.a[0] - motion.g[0], motion.alpha[0])
    np.testing.assert_allclose(regressor(motion)[0], pin.bodyRegressor(v, a)[:, PINOCCHIO_ORDER], atol=1e-10)


@given(seeds)
def test_a_frame_change_is_pinocchios_and_comes_back(seed: int) -> None:
    rng = np.random.default_rng(seed)
    body = random_payload(rng)
    R, p = Rotation.random(rng=rng).as_matrix(), rng.normal(size=3)
    moved = body.to_frame(R, p)
    expected = pin.Inertia.FromDynamicParameters(body.phi[PINOCCHIO_ORDER]).se3Action(pin.SE3(R, p))
    np.testing.assert_allclose(moved.phi[PINOCCHIO_ORDER], expected.toDynamicParameters(), rtol=1e-8, atol=1e-9)
    np.testing.assert_allclose(moved.to_frame(R.T, -R.T @ p).phi, body.phi, rtol=1e-8, atol=1e-9)


def test_a_frame_change_carries_the_covariance_along() -> None:
    rng = np.random.default_rng(4)
    A = frame_change(Rotation.random(rng=rng).as_matrix(), [0.1, -0.05, 0.2])
    root = rng.normal(size=(10, 10)) * 1e-3
    samples = np.array([A @ (root @ x) for x in rng.normal(size=(40_000, 10))])
    expected = A @ root @ root.T @ A.T
    spread = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    assert np.abs((np.cov(samples.T) - expected) / spread).max() < 0.03


@given(seeds)
def test_a_real_body_stays_consistent_in_every_frame(seed: int) -> None:
    rng = np.random.default_rng(seed)
    body = random_payload(rng)
    assert body.consistent
    assert body.to_frame(Rotation.random(rng=rng).as_matrix(), rng.normal(size=3)).consistent


@given(seeds)
def test_the_pseudo_inertia_round_trips_and_is_pinocchios(seed: int) -> None:
    body = random_payload(np.random.default_rng(seed))
    expected = pin.Inertia.FromDynamicParameters(body.phi[PINOCCHIO_ORDER]).toPseudoInertia().toMatrix()
    np.testing.assert_allclose(pseudo_inertia(body.phi), expected, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(phi_of_pseudo_inertia(body.pseudo_inertia), body.phi, rtol=1e-12, atol=1e-15)


def test_moments_that_break_the_triangle_inequality_are_not_consistent() -> None:
    assert not is_consistent(np.array([1.0, 0, 0, 0, 1e-3, 0, 0, 1e-3, 0, 2.1e-3]))
    assert is_consistent(np.array([1.0, 0, 0, 0, 1e-3, 0, 0, 1e-3, 0, 1.9e-3]))
    assert not is_consistent(np.array([-1.0, 0, 0, 0, 1e-3, 0, 0, 1e-3, 0, 1e-3]))


def test_six_numbers_and_a_symmetric_matrix_are_the_same_thing() -> None:
    six = np.arange(12.0).reshape(2, 6)
    np.testing.assert_array_equal(six_of(symmetric(six)), six)


def test_com_and_inertia_about_it_follow_the_parallel_axis_theorem() -> None:
    inertia = np.diag([2e-3, 3e-3, 4e-3])
    body = InertialParameters.from_com(1.5, [0.1, 0.0, 0.0], inertia)
    np.testing.assert_allclose(body.com, [0.1, 0.0, 0.0])
    np.testing.assert_allclose(body.inertia_com, inertia, atol=1e-15)
    np.testing.assert_allclose(np.diag(body.inertia), [2e-3, 3e-3 + 0.015, 4e-3 + 0.015])


@pytest.mark.parametrize("phi", [np.full(10, np.nan), np.zeros(9)])
def test_phi_that_is_not_ten_finite_numbers_is_refused(phi: np.ndarray) -> None:
    with pytest.raises(BadPayload, match="ten finite numbers"):
        InertialParameters(phi)
