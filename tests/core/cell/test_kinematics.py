"""Which robot it is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.cell.kinematics import is_same_robot, joint_axes
from core.cell.urdf import check_urdf
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
NAMES = ("lwr4_bench", "ur5e_line")


def axes_of(name: str, urdf: str | None = None) -> list[list[float]]:
    """Of a cell's robot, or of another file of it."""
    cell = load_cell(CELLS / name)
    text = cell.urdf if urdf is None else urdf
    joints = check_urdf(text, name).chain(cell.robot.base_frame, cell.robot.sensor_frame)
    return joint_axes(text, joints, cell.robot.base_frame, name)


@pytest.mark.parametrize("name", NAMES)
def test_the_axes_are_those_of_the_jacobian_at_zero(name: str) -> None:
    robot = RobotModel(RobotModel.of_cell(load_cell(CELLS / name)).description, where=name)
    zero = np.zeros(robot.n)
    pose = robot.sensor_pose(zero)
    v, w = (pose.rotation @ part for part in np.split(robot.sensor_jacobian(zero), 2))
    axes = np.array(axes_of(name))
    np.testing.assert_allclose(axes[:, :3], w.T, atol=1e-6)
    np.testing.assert_allclose(axes[:, 3:] + np.cross(axes[:, :3], pose.position), v.T, atol=1e-6)


def test_a_robot_is_itself_and_no_other() -> None:
    one, other = (axes_of(name) for name in NAMES)
    assert is_same_robot(one, one)
    assert not is_same_robot(one, other)


def test_a_file_written_otherwise_is_the_same_robot_and_a_longer_arm_is_another() -> None:
    text = load_cell(CELLS / "lwr4_bench").urdf
    assert is_same_robot(axes_of("lwr4_bench"), axes_of("lwr4_bench", text.replace("<link", "\n  <link").replace('name="lwr', 'name="arm')))
    longer = text.replace('xyz="0 0 0.2005"', 'xyz="0 0 0.3005"')
    assert longer != text
    assert not is_same_robot(axes_of("lwr4_bench"), axes_of("lwr4_bench", longer))
