"""Rotations of NumPy alone and compiled ones, against Pinocchio's."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from hypothesis import given
from hypothesis import strategies as st

from core.payload.rotations import cross, rotate_by, rotation_of, rotation_of_rpy, skew

vectors = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3).map(np.array)


@given(vectors, st.sampled_from([1.0, 1e-4, 1e-9]))
def test_rotation_vectors_turn_as_pinocchio_turns_them(vector: np.ndarray, size: float) -> None:
    np.testing.assert_allclose(rotation_of(size * vector), pin.exp3(size * vector), atol=1e-13)


@given(vectors)
def test_roll_pitch_and_yaw_turn_as_pinocchio_turns_them(rpy: np.ndarray) -> None:
    np.testing.assert_allclose(rotation_of_rpy(rpy), pin.rpy.rpyToMatrix(rpy), atol=1e-13)


@given(vectors, vectors)
def test_cross_products_are_numpys(u: np.ndarray, v: np.ndarray) -> None:
    np.testing.assert_allclose(cross(u, v), np.cross(u, v), atol=1e-13)
    np.testing.assert_allclose(skew(u) @ v, np.cross(u, v), atol=1e-13)


def test_many_turns_are_each_turn() -> None:
    rng = np.random.default_rng(3)
    vectors, x = np.vstack((np.zeros(3), rng.normal(size=(20, 3)))), rng.normal(size=3)
    np.testing.assert_allclose(rotate_by(vectors, x), [rotation_of(vector) @ x for vector in vectors], atol=1e-13)
