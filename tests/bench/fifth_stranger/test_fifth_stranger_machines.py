"""`bench.fifth_stranger.machines`: the sensor of each is where Pinocchio finds it in its URDF, and its noise has the machine's shape."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from bench.fifth_stranger.machines import MACHINES
from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.machines import Machine, load_machine
from bench.fourth_stranger.scene import Wish, draw_scene
from bench.second_stranger.kinematics import JointMotion, move_arm


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine.name)
def test_the_sensor_is_where_the_urdf_has_it(machine: Machine) -> None:
    q = np.random.default_rng(2).normal(size=(4, machine.joint_count))
    k = move_arm(machine, JointMotion(q, 0 * q, 0 * q), np.zeros((4, 3)))
    model = load_machine(machine)
    data, frame = model.createData(), model.getFrameId("ft_sensor")
    for i, each in enumerate(q):
        pin.framesForwardKinematics(model, data, each)
        np.testing.assert_allclose(k.R[i], data.oMf[frame].rotation, atol=1e-8)
        np.testing.assert_allclose(k.p[i], data.oMf[frame].translation, atol=1e-8)


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine.name)
def test_joints_bear_the_heaviest_payload_and_noise_is_shaped(machine: Machine) -> None:
    rig = draw_scene(np.random.default_rng(3), Wish(machine, Form(), "pick", 15, False, False)).rig
    assert np.all(np.abs(rig.torques).max(0) < machine.torque_limits)
    shaped = rig.noise_std[:3] / np.array([1, 1, 1.35]) / machine.noise_shape[:3]
    assert np.max(shaped) / np.min(shaped) < 1.5
