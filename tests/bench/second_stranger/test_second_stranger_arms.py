"""`bench.second_stranger`: motion and wrench of each arm's sensor are those that Pinocchio finds in its URDF."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from bench.second_stranger.arms import ARMS, Arm, describe_arm
from bench.second_stranger.kinematics import JointMotion, move_arm
from bench.second_stranger.rigid_body import Body, find_body_wrench, find_regressor

GRAVITY = np.array([0.1, 0.2, -9.8])
BODY = Body(2.3, np.array([0.03, -0.05, 0.08]), np.diag([0.01, 0.014, 0.008]) + 0.001)
UPPER = np.triu_indices(3)


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)
def test_the_sensor_moves_as_the_urdf_has_it(arm: Arm) -> None:
    states = np.random.default_rng(0).normal(size=(3, 4, arm.joint_count))
    k = move_arm(arm, JointMotion(*states), np.tile(GRAVITY, (4, 1)))
    model = pin.buildModelFromXML(describe_arm(arm))
    data, frame = model.createData(), model.getFrameId("ft_sensor")
    for i, state in enumerate(zip(*states, strict=True)):
        pin.forwardKinematics(model, data, *state)
        pin.updateFramePlacements(model, data)
        placement = data.oMf[frame]
        speed = pin.getFrameVelocity(model, data, frame, pin.LOCAL)
        acceleration = pin.getFrameClassicalAcceleration(model, data, frame, pin.LOCAL)
        np.testing.assert_allclose(k.R[i], placement.rotation, atol=1e-8)
        np.testing.assert_allclose(k.p[i], placement.translation, atol=1e-8)
        np.testing.assert_allclose(k.v[i], placement.rotation @ speed.linear, atol=1e-7)
        np.testing.assert_allclose(k.omega[i], speed.angular, atol=1e-7)
        np.testing.assert_allclose(k.alpha[i], acceleration.angular, atol=1e-7)
        np.testing.assert_allclose(k.u[i], acceleration.linear - placement.rotation.T @ GRAVITY, atol=1e-7)


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)
def test_the_sensor_reads_what_the_urdf_with_a_payload_asks_beyond_that_without(arm: Arm) -> None:
    states = np.random.default_rng(1).normal(size=(3, 4, arm.joint_count))
    k = move_arm(arm, JointMotion(*states), np.tile(GRAVITY, (4, 1)))
    alone, loaded = pin.buildModelFromXML(describe_arm(arm)), pin.buildModelFromXML(describe_arm(arm))
    frame = alone.frames[alone.getFrameId("ft_sensor")]
    loaded.appendBodyToJoint(frame.parentJoint, pin.Inertia(BODY.mass, BODY.com, BODY.inertia_at_com), frame.placement)
    asked = []
    for state in zip(*states, strict=True):
        forces = []
        for model in (alone, loaded):
            model.gravity.linear = GRAVITY
            data = model.createData()
            pin.rnea(model, data, *state)
            forces.append(data.f[frame.parentJoint].copy())
        asked.append(frame.placement.actInv(forces[1] - forces[0]).vector)
    np.testing.assert_allclose(find_body_wrench(k, BODY), asked, atol=1e-6)
    parameters = np.r_[BODY.mass, BODY.first_moment, BODY.inertia[UPPER]]
    np.testing.assert_allclose(find_regressor(k) @ parameters, asked, atol=1e-6)
