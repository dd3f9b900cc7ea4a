"""Joints on springs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.effects.joint_backlash import AT_ONCE_S, JointBacklash
from core.effects.joint_elasticity import JointElasticity
from tests.core.effects.mechanical_truth import T, believed, robot, scene, truth
from tests.core.effects.planted_mechanics import COMPLIANCE, PLAY


def test_without_joint_torques_the_payload_alone_bends_the_joints() -> None:
    bare, nominal = replace(scene(), torque=None), truth().wrench()
    stated = replace(scene(), torque=np.einsum("nij,ni->nj", np.stack([robot().sensor_jacobian(row) for row in believed(T)]), nominal))
    for effect, theta in (
        (JointElasticity(), np.array([*COMPLIANCE, 0.0, 0.1])),
        (JointBacklash(), np.append(PLAY, [0.5, 0.01, AT_ONCE_S])),
    ):
        np.testing.assert_allclose(effect.wrench(bare, nominal, theta), effect.wrench(stated, nominal, theta), atol=1e-5)
