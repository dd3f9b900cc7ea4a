import mujoco
import numpy as np
import pytest

from core.payload.inertia import InertialParameters
from core.plant.arm import arm_of_cell
from core.plant.controller import JointController
from core.plant.mechanics import Drives, build_model
from core.plant.virtual_robot import VirtualRobot
from tests.core.plant.plant_oracle import CARRIED, CELLS, NAMES, opposed_trapezoids, smooth_move


def follow(robot, path):
    """True positions, velocities and torques of all ticks."""
    truths = []
    for q_cmd in path:
        robot.step(q_cmd)
        truths.append(robot.truth)
    return tuple(np.array([getattr(truth, name) for truth in truths]) for name in ("q", "dq", "tau"))


@pytest.mark.parametrize(("cell", "name"), CARRIED, ids=NAMES)
def test_a_move_is_followed_within_a_milliradian_and_ends_at_rest(cell, name):
    robot = VirtualRobot(cell, cell.payloads[name].parameters, np.random.default_rng(0))
    away = robot.home + np.linspace(0.5, -0.6, robot.arm.n)
    path = np.vstack((smooth_move(robot.home, away, 1.5), np.tile(away, (500, 1))))
    q, dq, tau = follow(robot, path)
    assert np.abs(q - path).max() < 1e-3
    assert np.abs(q - path)[-200:].max() < 1e-6
    assert np.abs(dq)[-200:].max() < 1e-5
    assert (np.abs(tau) < robot.arm.effort).all()


@pytest.mark.parametrize("name", CELLS)
def test_the_papers_trapezoids_are_followed_and_leave_no_ringing(name):
    cell = CELLS[name]
    robot = VirtualRobot(cell, cell.payloads["steel_block"].parameters, np.random.default_rng(0))
    path = opposed_trapezoids(robot.home, robot.arm.n - 1, rate=0.9)
    q, dq, _ = follow(robot, path)
    assert np.abs(q - path).max() < 1e-3
    assert np.abs(dq[-700:]).max() < 1e-5
    windows = np.abs(dq[-1000:]).max(axis=1).reshape(10, 100).max(axis=1)
    assert (windows[1:] < np.maximum(windows[:-1] / 2, 1e-9)).all()


def test_a_heavy_payload_far_out_is_held_without_ringing():
    cell = CELLS["lwr4_bench"]
    stretched = cell.model_copy(update={"robot": cell.robot.model_copy(update={"home_rad": (0.0, 1.5, 0, 0.1, 0, 0.1, 0)})})
    payload = InertialParameters.from_com(7.0, [0.05, -0.05, 0.15], np.diag([0.08, 0.07, 0.05]))
    robot = VirtualRobot(stretched, payload, np.random.default_rng(0))
    away = robot.home + 0.2
    path = np.vstack((smooth_move(robot.home, away, 1.0), np.tile(away, (600, 1))))
    q, dq, _ = follow(robot, path)
    assert np.abs(q - path).max() < 1e-3
    assert np.abs(dq[-200:]).max() < 1e-5


@pytest.mark.parametrize(("cell", "name"), CARRIED, ids=NAMES)
def test_the_arm_stands_still_from_the_first_sample_on(cell, name):
    robot = VirtualRobot(cell, cell.payloads[name].parameters, np.random.default_rng(0))
    q, dq, _ = follow(robot, np.tile(robot.home, (300, 1)))
    assert np.abs(q - robot.home).max() < 1e-12
    assert np.abs(dq).max() < 1e-10


def test_the_feed_forward_does_not_know_the_payload():
    cell = CELLS["lwr4_bench"]
    path = smooth_move(np.array(cell.robot.home_rad), np.array(cell.robot.home_rad) + 0.4, 1.0)
    no_friction = Drives(friction=0.0)
    errors = {}
    for name, payload in (("bare", InertialParameters(np.zeros(10))), ("block", cell.payloads["steel_block"].parameters)):
        robot = VirtualRobot(cell, payload, np.random.default_rng(0), drives=no_friction)
        q, _, _ = follow(robot, path)
        errors[name] = np.abs(q - path).max()
    assert errors["block"] > 2 * errors["bare"] > 0


def test_torques_stay_within_the_drives_limits_and_the_integrator_does_not_wind_up():
    cell = CELLS["ur5e_line"]
    arm = arm_of_cell(cell)
    model = build_model(arm, InertialParameters(np.zeros(10)), cell.gravity, Drives(friction=0.0))
    data = mujoco.MjData(model)
    home = np.array(cell.robot.home_rad)
    data.qpos[:] = home
    mujoco.mj_forward(model, data)
    controller = JointController(model, torque_limit=arm.effort, acceleration_limit=np.full(arm.n, 40.0))
    controller.settle(home, data.qfrc_bias)
    calm = controller.torque(home, np.zeros(arm.n), home)
    np.testing.assert_allclose(calm, data.qfrc_bias, atol=1e-9)
    held = home.copy()
    held[0] += 0.5  # somebody holds the first joint away from its command
    for _ in range(2000):
        tau = controller.torque(held, np.zeros(arm.n), home)
        assert (np.abs(tau) <= arm.effort).all()
    assert tau[0] == -arm.effort[0]
    released = controller.torque(home, np.zeros(arm.n), home)
    np.testing.assert_allclose(released, calm, atol=1e-6)


def test_a_jerky_command_is_limited_in_acceleration_and_followed_all_the_same():
    cell = CELLS["lwr4_bench"]
    robot = VirtualRobot(cell, cell.payloads["cylinder"].parameters, np.random.default_rng(0))
    path = np.tile(robot.home + 1e-3, (800, 1))
    q, dq, tau = follow(robot, path)
    assert (np.abs(tau) <= robot.arm.effort).all()
    assert np.abs(q[-1] - path[-1]).max() < 1e-6
    assert np.abs(dq[-1]).max() < 1e-5
