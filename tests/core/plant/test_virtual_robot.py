import dataclasses

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.payload.inertia import InertialParameters
from core.plant.imperfections import Imperfections, LinearOffsetDrift
from core.plant.mechanics import Drives
from core.plant.virtual_robot import VirtualRobot
from tests.core.plant.plant_oracle import CARRIED, CELLS, NAMES, PinocchioArm, smooth_move

STEPS = np.linspace(1.0, -1.0, 7)


def run(robot, path):
    return [(robot.step(q_cmd), robot.truth) for q_cmd in path]


def short_move(robot, seconds=0.6):
    return smooth_move(robot.home, robot.home + 0.25 * STEPS[: robot.arm.n], seconds)


@pytest.mark.parametrize(("cell", "name"), CARRIED, ids=NAMES)
def test_the_true_wrench_is_equation_1_of_the_true_motion(cell, name):
    payload = cell.payloads[name].parameters
    robot = VirtualRobot(cell, payload, np.random.default_rng(0))
    oracle = PinocchioArm.of(cell, payload, cell.gravity)
    for _, truth in run(robot, short_move(robot))[::7]:
        expected = oracle.wrench(payload.phi, truth.q, truth.dq, truth.ddq)
        np.testing.assert_allclose(truth.wrench, expected, atol=1e-9)


@pytest.mark.parametrize("name", CELLS)
def test_the_true_acceleration_is_forward_dynamics_of_the_drive_torque(name):
    cell = CELLS[name]
    payload, drives = cell.payloads["steel_block"].parameters, Drives(friction=0.0)
    robot = VirtualRobot(cell, payload, np.random.default_rng(0), drives=drives)
    oracle = PinocchioArm.of(cell, payload, cell.gravity)
    for _, truth in run(robot, short_move(robot))[::7]:
        expected = oracle.acceleration(drives, truth.q, truth.dq, truth.tau)
        np.testing.assert_allclose(truth.ddq, expected, rtol=1e-8, atol=1e-8)


@pytest.mark.parametrize("name", CELLS)
def test_wrench_and_positions_are_of_the_same_instant(name):
    """Second differences of the true positions are the accelerations in the wrench: no delay hides in the simulation."""
    cell = CELLS[name]
    robot = VirtualRobot(cell, cell.payloads["steel_block"].parameters, np.random.default_rng(0))
    truths = [truth for _, truth in run(robot, short_move(robot))]
    q, ddq = np.array([t.q for t in truths]), np.array([t.ddq for t in truths])
    np.testing.assert_allclose(np.diff(q, n=2, axis=0) / 1e-6, ddq[1:-1], atol=1e-6)


@pytest.mark.parametrize("name", CELLS)
def test_a_sample_is_the_truth_with_the_instruments_errors(name):
    cell = CELLS[name]
    robot = VirtualRobot(cell, cell.payloads["cylinder"].parameters, np.random.default_rng(3))
    rows = run(robot, short_move(robot))
    t = np.array([s.t for s, _ in rows])
    np.testing.assert_allclose(t, 0.001 * np.arange(len(rows)), atol=1e-12)
    assert np.abs([s.q - w.q for s, w in rows]).max() < 2e-5
    wrench_error = np.array([s.wrench - w.wrench - w.offset for s, w in rows])
    assert (np.abs(wrench_error) < 6 * np.array(cell.sensor.noise_std)).all()
    tau_error = np.array([s.tau - w.tau for s, w in rows])
    np.testing.assert_allclose(tau_error.std(0), 1e-3 * robot.arm.effort, rtol=0.2)
    dq_error = np.array([s.dq - w.dq for s, w in rows])
    assert np.abs(dq_error).max() < 0.02


def test_at_rest_with_x_along_gravity_the_force_is_minus_the_weight():
    cell = CELLS["lwr4_bench"]
    payload = cell.payloads["steel_block"].parameters
    along_x = np.array([0.0, -0.35, 0.0, 1.75, 0.0, -1.05 + 0.5, 0.0])
    found = cell.model_copy(update={"robot": cell.robot.model_copy(update={"home_rad": tuple(along_x)})})
    robot = VirtualRobot(found, payload, np.random.default_rng(0))
    robot.step(robot.home)
    R = robot_rotation(found, along_x)
    np.testing.assert_allclose(robot.truth.wrench[:3], -payload.mass * R.T @ cell.gravity, atol=1e-9)
    np.testing.assert_allclose(robot.truth.wrench[3:], np.cross(payload.first_moment, -R.T @ cell.gravity), atol=1e-9)


def robot_rotation(cell, q):
    from core.robot.model import RobotModel

    return RobotModel.of_cell(cell).sensor_pose(q).rotation


def test_the_same_seed_gives_the_same_run_and_another_seed_another():
    cell = CELLS["lwr4_bench"]
    payload = cell.payloads["gripper"].parameters

    def samples(seed):
        robot = VirtualRobot(cell, payload, np.random.default_rng(seed))
        return [sample for sample, _ in run(robot, short_move(robot, 0.7))]

    first, again, other = samples(5), samples(5), samples(6)
    for a, b in zip(first, again, strict=True):
        for field in dataclasses.fields(a):
            np.testing.assert_array_equal(getattr(a, field.name), getattr(b, field.name))
    assert not np.array_equal(first[-1].wrench, other[-1].wrench)
    assert not np.array_equal(first[-1].q, other[-1].q)


@pytest.mark.parametrize("name", CELLS)
def test_a_tilted_base_shows_as_gravity_turned_about_the_bases_axes(name):
    cell = CELLS[name]
    tilt = (np.deg2rad(0.5), -np.deg2rad(0.3))
    payload = cell.payloads["steel_block"].parameters
    robot = VirtualRobot(cell, payload, np.random.default_rng(0), imperfections=Imperfections(base_tilt_rad=tilt))
    base = cell.robot.base.rotation
    gravity_in_base = Rotation.from_rotvec([*tilt, 0]).apply(base.T @ cell.gravity)
    angle = np.arccos(gravity_in_base @ base.T @ cell.gravity / (9.81 * 9.81))
    assert abs(angle - np.hypot(*tilt)) < 1e-6
    # small angles: a positive tilt about x lifts gravity (0, 0, -g) towards +y, one about y pushes it towards -x
    np.testing.assert_allclose(gravity_in_base[:2], 9.81 * np.array([-tilt[1], tilt[0]]), rtol=1e-4)
    oracle = PinocchioArm.of(cell, payload, base @ gravity_in_base)
    for _, truth in run(robot, short_move(robot))[::20]:
        expected = oracle.wrench(payload.phi, truth.q, truth.dq, truth.ddq)
        np.testing.assert_allclose(truth.wrench, expected, atol=1e-9)


def test_planted_imperfections_leave_the_motion_alone_and_change_the_wrench():
    cell = CELLS["ur5e_line"]
    payload = cell.payloads["steel_block"].parameters
    drift = LinearOffsetDrift((0.3, 0, 0, 0, 0, 0), duration_s=0.6)
    planted = Imperfections(wrench_delay_s=0.004, offset_drift=(drift,))
    clean = VirtualRobot(cell, payload, np.random.default_rng(2))
    faulty = VirtualRobot(cell, payload, np.random.default_rng(2), imperfections=planted)
    path = short_move(clean)
    a, b = run(clean, path), run(faulty, path)
    np.testing.assert_array_equal([s.q for s, _ in a], [s.q for s, _ in b])
    true = np.array([truth.wrench for _, truth in a])
    change = np.array([y.wrench - x.wrench for (x, _), (y, _) in zip(a, b, strict=True)])[4:]
    expected = true[:-4] - true[4:] + np.outer(0.001 * np.arange(4, len(a)), [0.5, 0, 0, 0, 0, 0])
    assert (np.abs(change - expected) <= 1.001 * np.array(cell.sensor.resolution)).all()


def test_an_empty_hand_reads_offset_and_noise_only():
    cell = CELLS["lwr4_bench"]
    robot = VirtualRobot(cell, InertialParameters(np.zeros(10)), np.random.default_rng(0))
    for sample, truth in run(robot, short_move(robot, 0.2)):
        np.testing.assert_array_equal(truth.wrench, 0.0)
        assert (np.abs(sample.wrench - truth.offset) < 6 * np.array(cell.sensor.noise_std)).all()


def test_there_is_no_truth_before_the_first_step():
    cell = CELLS["lwr4_bench"]
    robot = VirtualRobot(cell, cell.payloads["cylinder"].parameters, np.random.default_rng(0))
    with pytest.raises(RuntimeError, match="no step"):
        _ = robot.truth
