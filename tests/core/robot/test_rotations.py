"""The compiled rotations and pose differences, against Pinocchio's."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from hypothesis import given
from hypothesis import strategies as st

from core.robot.rotations import exponential, logarithm, pose_error

seeds = st.integers(0, 2**32 - 1)


@given(seeds, st.sampled_from([1e-12, 1e-6, 1e-3, 1.0, 3.0]))
def test_rotations_and_their_vectors_are_pinocchios(seed: int, size: float) -> None:
    v = np.random.default_rng(seed).normal(size=3)
    v *= size / np.linalg.norm(v)
    R, back = np.empty((3, 3)), np.empty(3)
    exponential(v, R)
    np.testing.assert_allclose(R, pin.exp3(v), atol=1e-14)
    logarithm(pin.exp3(v), back)
    np.testing.assert_allclose(back, v, atol=1e-12 * (1 + 1 / (np.pi - size)))


@given(seeds)
def test_the_way_from_pose_to_pose_is_translation_and_rotation_vector_in_the_first_poses_axes(seed: int) -> None:
    rng = np.random.default_rng(seed)
    here, there = pin.SE3.Random(), pin.SE3.Random()
    here.translation, there.translation = rng.normal(size=3), rng.normal(size=3)
    here.rotation, there.rotation = pin.exp3(rng.normal(size=3)), pin.exp3(rng.normal(size=3))
    e = np.empty(6)
    pose_error(here.rotation.copy(), here.translation.copy(), there.rotation.copy(), there.translation.copy(), e)
    between = here.actInv(there)
    np.testing.assert_allclose(e[:3], between.translation, atol=1e-13)
    assert np.allclose(pin.exp3(e[3:]), between.rotation, atol=1e-9)
