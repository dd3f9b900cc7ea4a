import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from core.plant.braking import braking_positions

PERIOD = 0.001
joints = arrays(float, 6, elements=st.floats(-3, 3))
limits = arrays(float, 6, elements=st.floats(0.5, 20))


@given(q=joints, dq=joints, acceleration=limits)
def test_braking_keeps_the_accelerations_and_ends_at_rest(q, dq, acceleration):
    path = np.vstack((q - PERIOD * dq, q, braking_positions(q, dq, acceleration, period=PERIOD)))
    path = np.vstack((path, path[-1]))
    ddq = np.diff(path, n=2, axis=0) / PERIOD**2
    assert (np.abs(ddq) <= acceleration * (1 + 1e-9) + 1e-8).all()


@given(q=joints, dq=joints, acceleration=limits)
def test_braking_keeps_the_direction_and_never_gets_faster(q, dq, acceleration):
    path = np.vstack((q, braking_positions(q, dq, acceleration, period=PERIOD)))
    steps = np.diff(path, axis=0) / PERIOD
    share = steps @ dq / max(dq @ dq, 1e-300)
    np.testing.assert_allclose(steps, np.outer(share, dq), atol=1e-9)
    assert ((share <= 1) & (share >= -1e-9)).all()


@given(q=joints, dq=joints, acceleration=limits)
def test_braking_takes_no_longer_than_the_slowest_joint_needs(q, dq, acceleration):
    path = braking_positions(q, dq, acceleration, period=PERIOD)
    assert len(path) - 1 <= np.max(np.abs(dq) / acceleration) / PERIOD <= len(path)
    travel = np.abs(np.vstack((q, path))[-1] - q)
    assert (travel <= np.abs(dq) * len(path) * PERIOD / 2 + 1e-9).all()


def test_an_arm_at_rest_need_not_brake():
    assert len(braking_positions(np.ones(6), np.zeros(6), np.ones(6), period=PERIOD)) == 0
