"""Eq. (5)."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.offset import OpposedPoses, offset_of_opposed_poses, pose_of_gravity
from core.payload.inertia import Motion
from core.payload.rigid_wrench import wrench
from tests.synthetic import payload

OFFSET = np.array([3.0, -2.0, 5.0, 0.1, -0.2, 0.3])


def opposed(axes: str) -> np.ndarray:
    return np.array([sign * 9.81 * np.eye(3)["xyz".index(a)] for a in axes for sign in (-1, 1)])


def test_opposed_poses_give_the_offset_of_every_axis_exactly() -> None:
    g = opposed("xyz")
    raw = wrench(Motion.still(g), payload("steel_block").phi) + OFFSET
    np.testing.assert_allclose(offset_of_opposed_poses(g, raw), OFFSET, atol=1e-12)
    running = OpposedPoses()
    for one, w in zip(g, raw, strict=True):
        running.add(one, w)
    np.testing.assert_allclose(running.offset, OFFSET, atol=1e-12)


def test_unequal_times_in_the_two_poses_do_not_shift_the_offset() -> None:
    g = np.repeat(opposed("xyz"), [3, 50, 1, 7, 20, 2], axis=0)
    raw = wrench(Motion.still(g), payload("steel_block").phi) + OFFSET
    np.testing.assert_allclose(offset_of_opposed_poses(g, raw), OFFSET, atol=1e-12)


def test_an_axis_that_was_not_seen_both_ways_has_no_offset() -> None:
    g = opposed("xy")
    raw = wrench(Motion.still(g), payload("steel_block").phi) + OFFSET
    assert np.isnan(offset_of_opposed_poses(g, raw)).tolist() == [False, False, True, False, False, True]


@pytest.mark.parametrize(
    ("g", "pose"), [([9.81, 0, 0], (0, 1)), ([0, -9.81, 0.1], (1, -1)), ([7.0, 7.0, 0.0], None), ([1.2, 0, 9.7], None)]
)
def test_a_pose_counts_when_an_axis_lies_along_gravity(g: list, pose: tuple | None) -> None:
    assert pose_of_gravity(np.array(g)) == pose
