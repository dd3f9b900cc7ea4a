"""Principal axes and the ways to write a rotation, against Pinocchio's."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.export.principal_axes import principal_axes, to_quaternion, zyx_degrees
from core.payload.inertia import six_of, symmetric

angles = st.floats(-np.pi, np.pi)


@given(angles, st.one_of(angles, st.just(np.pi / 2), st.just(-np.pi / 2)), angles)
def test_angles_and_quaternion_turn_back_into_the_rotation(a: float, b: float, c: float):
    turn = pin.rpy.rpyToMatrix(c, b, a)
    again = pin.rpy.rpyToMatrix(*np.radians(zyx_degrees(turn))[::-1])
    np.testing.assert_allclose(again, turn, atol=1e-8)
    w, x, y, z = to_quaternion(turn)
    assert w >= 0.0
    np.testing.assert_allclose(pin.Quaternion(w, x, y, z).matrix(), turn, atol=1e-9)


@given(st.tuples(*[st.floats(0.01, 1.0)] * 3), angles, angles, angles)
def test_moments_and_axes_make_the_inertia_again_with_a_right_handed_frame(moments, a: float, b: float, c: float):
    turn = pin.rpy.rpyToMatrix(c, b, a)
    inertia = turn @ np.diag(moments) @ turn.T
    found = principal_axes(six_of(inertia))
    np.testing.assert_allclose(found.rotation @ np.diag(found.moments) @ found.rotation.T, inertia, atol=1e-12)
    assert np.linalg.det(found.rotation) == pytest.approx(1.0)


@pytest.mark.parametrize("moments", [(3.0, 2.0, 1.0), (1.0, 3.0, 2.0), (2.0, 1.0, 3.0)])
def test_axes_that_lie_along_the_frame_are_not_turned_at_all(moments):
    found = principal_axes(np.array([moments[0], 0.0, 0.0, moments[1], 0.0, moments[2]]))
    np.testing.assert_allclose(found.rotation, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(found.moments, moments)
    assert symmetric(np.array([moments[0], 0.0, 0.0, moments[1], 0.0, moments[2]])).trace() == sum(moments)
