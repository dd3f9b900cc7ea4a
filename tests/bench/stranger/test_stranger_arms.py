"""`bench.stranger.kinematics`: motion and gravity's loads of each arm are those that Pinocchio finds in its URDF."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from bench.stranger.arms import ARMS, Arm, describe_arm
from bench.stranger.kinematics import find_loads, move_arm
from bench.stranger.rig import GRAVITY

MASS, COM = 2.3, np.array([0.02, -0.03, 0.08])


@pytest.mark.parametrize("arm", ARMS.values(), ids=lambda arm: arm.name)
def test_the_sensor_moves_as_the_urdf_has_it(arm: Arm) -> None:
    states = np.random.default_rng(0).normal(size=(3, 4, len(arm.joints)))
    q, dq, ddq = states
    k = move_arm(arm, q, dq, ddq, GRAVITY)
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


@pytest.mark.parametrize("arm", ARMS.values(), ids=lambda arm: arm.name)
def test_gravity_loads_the_joints_as_the_urdf_has_it(arm: Arm) -> None:
    q = np.random.default_rng(1).normal(size=(4, len(arm.joints)))
    loads = find_loads(arm, q, GRAVITY, move_arm(arm, q, 0 * q, 0 * q, GRAVITY), MASS, COM)
    model = pin.buildModelFromXML(describe_arm(arm))
    alone = [pin.computeGeneralizedGravity(model, model.createData(), each) for each in q]
    np.testing.assert_allclose(loads.of_payload - loads.of_all, alone, atol=1e-6)
    frame = model.frames[model.getFrameId("ft_sensor")]
    model.appendBodyToJoint(frame.parentJoint, pin.Inertia(MASS, COM, np.zeros((3, 3))), frame.placement)
    loaded = [pin.computeGeneralizedGravity(model, model.createData(), each) for each in q]
    np.testing.assert_allclose(-loads.of_all, loaded, atol=1e-6)
