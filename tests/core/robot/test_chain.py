"""The compiled kinematics against Pinocchio and against finite differences."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.cell.folder import load_cell
from core.robot.chain import forward, forward_many, jacobian
from core.robot.dynamics import LinkDynamics
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
NAMES = sorted(folder.name for folder in CELLS.iterdir() if folder.is_dir())

robots = cache(lambda name: RobotModel.of_cell(load_cell(CELLS / name)))


@settings(max_examples=60, deadline=None)
@given(name=st.sampled_from(NAMES), seed=st.integers(0, 2**32 - 1))
def test_pose_and_jacobian_are_pinocchios(name: str, seed: int) -> None:
    robot = robots(name)
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, robot.n)
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    pose = data.oMf[robot.sensor_frame_id]
    J = pin.computeFrameJacobian(robot.model, data, q, robot.sensor_frame_id, pin.LOCAL)
    np.testing.assert_allclose(forward(robot.chain, q), pose.homogeneous, atol=1e-12)
    np.testing.assert_allclose(jacobian(robot.chain, q), J, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_the_jacobian_is_the_derivative_of_the_pose_in_sensor_axes(name: str) -> None:
    robot = robots(name)
    h = 1e-6
    for q in np.random.default_rng(5).uniform(-2, 2, (5, robot.n)):
        R = forward(robot.chain, q)[:3, :3]
        for j, e in enumerate(np.eye(robot.n)):
            before, after = forward(robot.chain, q - h * e), forward(robot.chain, q + h * e)
            linear = R.T @ (after[:3, 3] - before[:3, 3]) / (2 * h)
            turned = Rotation.from_matrix(before[:3, :3].T @ after[:3, :3]).as_rotvec() / (2 * h)
            np.testing.assert_allclose(jacobian(robot.chain, q)[:, j], [*linear, *turned], atol=1e-8)


@pytest.mark.parametrize("name", NAMES)
def test_many_poses_are_each_pose(name: str) -> None:
    robot = robots(name)
    q = np.random.default_rng(6).uniform(-3, 3, (30, robot.n))
    np.testing.assert_array_equal(forward_many(robot.chain, q), [forward(robot.chain, row) for row in q])
    poses = robot.sensor_poses(q)
    np.testing.assert_array_equal(poses.position[7], robot.sensor_pose(q[7]).position)
    np.testing.assert_array_equal(poses.rotation[7], robot.sensor_pose(q[7]).rotation)


@pytest.mark.parametrize("name", NAMES)
def test_the_first_moment_of_the_links_is_pinocchios(name: str) -> None:
    robot = robots(name)
    q = np.random.default_rng(7).uniform(-3, 3, (20, robot.n))
    data, mass = robot.model.createData(), pin.computeTotalMass(robot.model)
    expected = [mass * pin.centerOfMass(robot.model, data, row) for row in q]
    np.testing.assert_allclose(LinkDynamics(robot, np.zeros(3)).first_moment(q), expected, atol=1e-12)
