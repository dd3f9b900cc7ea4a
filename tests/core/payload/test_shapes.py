"""Where shapes are."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.payload.shapes import Pose

angle = st.floats(-2 * np.pi, 2 * np.pi)


@given(rpy=st.tuples(angle, angle, angle))
def test_a_pose_turns_by_roll_then_pitch_then_yaw_about_the_fixed_axes(rpy: tuple[float, float, float]) -> None:
    turned = Pose(rpy_rad=rpy).rotation
    np.testing.assert_allclose(turned, Rotation.from_euler("xyz", rpy).as_matrix(), atol=1e-15)


def test_a_quarter_turn_about_z_takes_x_to_y() -> None:
    np.testing.assert_allclose(Pose(rpy_rad=(0.0, 0.0, np.pi / 2)).rotation @ [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], atol=1e-15)
