"""`bench.third_stranger`: motion and wrench of each new arm's sensor, bent or not, are those that Pinocchio finds in its URDF."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest

from bench.second_stranger.arms import Arm, describe_arm
from bench.second_stranger.kinematics import JointMotion, move_arm
from bench.second_stranger.rigid_body import Body, find_body_wrench
from bench.third_stranger.arms import ARMS, HOLLOW

GRAVITY = np.array([4.9, 0.3, -8.5])
BODY = Body(3.1, np.array([0.02, 0.04, 0.07]), np.diag([0.012, 0.009, 0.015]) + 0.001)
BENT = replace(HOLLOW, name="bent", dh=(*HOLLOW.dh[:2], (0, 0.09, HOLLOW.dh[2][2] + 0.02), *HOLLOW.dh[3:]))


@pytest.mark.parametrize("arm", [*ARMS, BENT], ids=lambda arm: arm.name)
def test_the_sensor_moves_and_reads_as_the_urdf_has_it(arm: Arm) -> None:
    states = np.random.default_rng(2).normal(size=(3, 5, arm.joint_count))
    k = move_arm(arm, JointMotion(*states), np.tile(GRAVITY, (5, 1)))
    alone, loaded = (pin.buildModelFromXML(describe_arm(arm)) for _ in range(2))
    number = alone.getFrameId("ft_sensor")
    frame = alone.frames[number]
    loaded.appendBodyToJoint(frame.parentJoint, pin.Inertia(BODY.mass, BODY.com, BODY.inertia_at_com), frame.placement)
    asked = []
    for i, state in enumerate(zip(*states, strict=True)):
        forces = []
        for model in (alone, loaded):
            model.gravity.linear = GRAVITY
            data = model.createData()
            pin.rnea(model, data, *state)
            forces.append(data.f[frame.parentJoint].copy())
        asked.append(frame.placement.actInv(forces[1] - forces[0]).vector)
        pin.framesForwardKinematics(alone, data, state[0])
        np.testing.assert_allclose(k.R[i], data.oMf[number].rotation, atol=1e-8)
        np.testing.assert_allclose(k.p[i], data.oMf[number].translation, atol=1e-8)
    np.testing.assert_allclose(find_body_wrench(k, BODY), asked, atol=1e-6)
