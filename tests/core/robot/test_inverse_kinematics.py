from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.robot.inverse_kinematics import TOLERANCE, solve_poses
from core.robot.model import RobotModel


def sensor_pose_of_pinocchio(robot: RobotModel, q: np.ndarray) -> pin.SE3:
    pin.framesForwardKinematics(robot.model, robot.data, q)
    return robot.data.oMf[robot.sensor_frame_id].copy()


@pytest.fixture(scope="module")
def robot(cell) -> RobotModel:
    return RobotModel.of_cell(cell)


def attempts(robot: RobotModel, count: int, seed: int, away: float) -> tuple[np.ndarray, list[pin.SE3]]:
    rng = np.random.default_rng(seed)
    lower, upper = np.maximum(robot.lower, -np.pi), np.minimum(robot.upper, np.pi)
    goal = rng.uniform(lower, upper, (count, robot.n))
    start = np.clip(goal + rng.normal(0.0, away, goal.shape), robot.lower, robot.upper)
    return start, [sensor_pose_of_pinocchio(robot, q) for q in goal]


def solve(robot: RobotModel, start: np.ndarray, poses: list[pin.SE3]):
    rotations, positions = np.array([pose.rotation for pose in poses]), np.array([pose.translation for pose in poses])
    return solve_poses(robot.chain, robot.lower, robot.upper, start, rotations, positions)


@given(st.integers(0, 2**32 - 1), st.floats(0.0, 1.0))
def test_what_is_called_solved_is_at_the_pose_and_within_the_limits(robot, seed, away):
    start, poses = attempts(robot, 30, seed, away)
    solutions = solve(robot, start, poses)
    for q, pose, solved in zip(solutions.q, poses, solutions.solved, strict=True):
        assert ((q >= robot.lower) & (q <= robot.upper)).all()
        if solved:
            error = pin.log6(pose.actInv(sensor_pose_of_pinocchio(robot, q))).vector
            assert np.abs(error).max() < 2 * TOLERANCE


def test_nearly_every_pose_is_found_from_a_start_nearby(robot):
    solutions = solve(robot, *attempts(robot, 500, 0, 0.2))
    assert solutions.solved.mean() > 0.9


def test_a_pose_out_of_reach_is_not_solved(robot):
    start, poses = attempts(robot, 20, 0, 0.2)
    far = [pin.SE3(pose.rotation, pose.translation + np.array([3.0, 0.0, 0.0])) for pose in poses]
    assert not solve(robot, start, far).solved.any()


def test_the_starts_are_left_as_they_were(robot):
    start, poses = attempts(robot, 5, 0, 0.2)
    before = start.copy()
    solve(robot, start, poses)
    assert (start == before).all()
