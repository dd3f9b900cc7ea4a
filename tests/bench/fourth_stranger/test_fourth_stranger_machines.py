"""`bench.fourth_stranger`: motion and wrench of each machine's sensor, however it is turned, are those that Pinocchio finds in its URDF."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from bench.fourth_stranger.machines import DESK, MACHINES, PLANAR, UPRIGHT, Machine, load_machine
from bench.second_stranger.kinematics import JointMotion, move_arm
from bench.second_stranger.rigid_body import Body, find_body_wrench

GRAVITY = np.array([4.9, 0.3, -8.5])
BODY = Body(3.1, np.array([0.02, 0.04, 0.07]), np.diag([0.012, 0.009, 0.015]) + 0.001)


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine.name)
def test_the_sensor_moves_and_reads_as_the_urdf_has_it(machine: Machine) -> None:
    states = np.random.default_rng(2).normal(size=(3, 5, machine.joint_count))
    k = move_arm(machine, JointMotion(*states), np.tile(GRAVITY, (5, 1)))
    alone, loaded = (load_machine(machine) for _ in range(2))
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


def test_a_linked_machine_keeps_its_tool_upright() -> None:
    q = UPRIGHT.link(np.random.default_rng(1).uniform(-1, 1, (50, 5)))
    np.testing.assert_allclose(_tell_vertical(UPRIGHT, q), -1, atol=1e-12)


def test_a_planar_machine_turns_its_tool_about_one_axis() -> None:
    axis = _find_axes(PLANAR, np.random.default_rng(1).uniform(-1, 1, (50, 4)), np.array([0, 0, 1.0]))
    np.testing.assert_allclose(axis, np.tile(axis[0], (50, 1)), atol=1e-12)


def test_a_machine_that_is_not_linked_goes_where_it_is_told() -> None:
    q = np.random.default_rng(1).uniform(-1, 1, (5, 6))
    np.testing.assert_array_equal(DESK.link(q), q)


def _find_axes(machine: Machine, q: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """(N, 3), sensor axes, of a direction (3,), base axes."""
    nothing = 0 * q
    return move_arm(machine, JointMotion(q, nothing, nothing), np.zeros((len(q), 3))).turn_into_sensor(np.tile(direction, (len(q), 1)))


def _tell_vertical(machine: Machine, q: np.ndarray) -> np.ndarray:
    """(N,), how far the last joint's axis points up."""
    model = load_machine(machine)
    data = model.createData()
    found = []
    for each in q:
        pin.forwardKinematics(model, data, each)
        found.append(data.oMi[model.njoints - 1].rotation[2, 2])
    return np.array(found)
