import mujoco
import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from core.payload.inertia import InertialParameters
from core.plant.mechanics import to_mujoco_quaternion
from core.plant.principal import principal_inertia

vectors = arrays(float, 3, elements=st.floats(-2, 2))


@given(density=arrays(float, 3, elements=st.floats(0.01, 1)), turn=vectors, com=vectors, mass=st.floats(0.01, 20))
def test_moments_and_axes_give_the_inertia_back(density, turn, com, mass):
    R = Rotation.from_rotvec(turn).as_matrix()
    inertia_com = mass * R @ (density.sum() * np.eye(3) - np.diag(density)) @ R.T
    principal = principal_inertia(InertialParameters.from_com(mass, com, inertia_com))
    A, B, C = principal.moments
    assert 0 < A <= B <= C <= A + B
    assert np.linalg.det(principal.axes) > 0.999
    back = principal.axes @ np.diag(principal.moments) @ principal.axes.T
    np.testing.assert_allclose(back, inertia_com, atol=1e-12 + 1e-13 * mass * (com @ com + 1) * 100)


def test_a_flat_plate_is_a_body():
    plate = InertialParameters.from_com(1.3, [0.1, 0.2, 0.3], np.diag([0.011, 0.017, 0.028]))
    A, B, C = principal_inertia(plate).moments
    assert A + B >= C


@given(turn=vectors, v=vectors)
def test_quaternions_are_in_mujocos_order(turn, v):
    R = Rotation.from_rotvec(turn).as_matrix()
    turned = np.zeros(3)
    mujoco.mju_rotVecQuat(turned, v, to_mujoco_quaternion(R))
    np.testing.assert_allclose(turned, R @ v, atol=1e-12)
