"""Kinematics of an arm in the world frame, against Pinocchio's own and against matrices written out by hand."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from core.cell.cell import Pose
from core.cell.folder import load_cell
from core.cell.urdf_tree import UrdfTree
from core.errors import BadCell, BadRobot
from core.recording.recording import RobotDescription
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
NAMES = sorted(folder.name for folder in CELLS.iterdir() if folder.is_dir())


def lwr(**changes: object) -> RobotDescription:
    text = (CELLS / "lwr4_bench" / "robot.urdf").read_text()
    description = RobotDescription(text, tuple(f"joint{j}" for j in range(1, 8)), "base", "ft_sensor")
    return replace(description, **changes)


def test_the_stretched_arm_is_as_long_as_its_links() -> None:
    pose = RobotModel(lwr()).sensor_pose(np.zeros(7))
    np.testing.assert_allclose(pose.position, [0, 0, 0.11 + 0.2005 + 0.2 + 0.2 + 0.2 + 0.19 + 0.0937], atol=1e-12)
    np.testing.assert_allclose(pose.rotation, np.eye(3), atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_a_moved_base_moves_the_sensor_rigidly(name: str) -> None:
    cell = load_cell(CELLS / name)
    base = Pose(xyz_m=(0.3, -0.2, 0.5), rpy_rad=(0.1, -0.4, 1.2))
    moved = RobotModel.of_cell(cell.model_copy(update={"robot": cell.robot.model_copy(update={"base": base})}))
    home = RobotModel.of_cell(cell.model_copy(update={"robot": cell.robot.model_copy(update={"base": Pose()})}))
    turn = Rotation.from_euler("xyz", base.rpy_rad).as_matrix()
    for q in np.random.default_rng(0).uniform(home.lower, home.upper, (20, home.n)):
        there, here = moved.sensor_pose(q), home.sensor_pose(q)
        np.testing.assert_allclose(there.position, turn @ here.position + base.xyz_m, atol=1e-12)
        np.testing.assert_allclose(there.rotation, turn @ here.rotation, atol=1e-12)
        np.testing.assert_allclose(moved.sensor_jacobian(q), home.sensor_jacobian(q), atol=1e-12)


def test_gravitys_frame_is_the_base_frame_wherever_that_is_in_the_urdf() -> None:
    text = lwr().urdf.replace(
        '<link name="base">',
        '<link name="table"/><joint name="bolt" type="fixed"><parent link="table"/><child link="base"/>'
        '<origin xyz="1 2 3" rpy="0.3 0.2 0.1"/></joint><link name="base">',
    )
    on_table = RobotModel(lwr(urdf=text))
    alone = RobotModel(lwr())
    q = np.array([0.3, -0.5, 0.2, 1.1, -0.4, 0.6, 0.9])
    np.testing.assert_allclose(on_table.sensor_pose(q).position, alone.sensor_pose(q).position, atol=1e-12)
    np.testing.assert_allclose(on_table.sensor_pose(q).rotation, alone.sensor_pose(q).rotation, atol=1e-12)


def test_joints_before_the_base_frame_and_beside_the_chain_do_not_count() -> None:
    q = np.array([0.4, -0.7, 0.2])
    forearm = RobotModel(lwr(joints=("joint5", "joint6", "joint7"), base_frame="link4"))
    whole = RobotModel(lwr())
    elbow = pin.buildModelFromXML(lwr().urdf)
    data = elbow.createData()
    full = np.concatenate([np.full(4, 0.3), q])
    pin.framesForwardKinematics(elbow, data, full)
    link4 = data.oMf[elbow.getFrameId("link4")]
    there = link4.act(forearm.sensor_pose(q).position)
    np.testing.assert_allclose(there, whole.sensor_pose(full).position, atol=1e-12)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"joints": ("joint1", "joint2")}, "chain's joints in its order"),
        ({"joints": tuple(f"joint{j}" for j in range(7, 0, -1))}, "chain's joints in its order"),
        ({"sensor_frame": "hand"}, "frame: found 'hand'"),
        ({"base_frame": "hand"}, "frame: found 'hand'"),
        ({"urdf": "<robot"}, "does not parse"),
    ],
)
def test_a_description_that_does_not_fit_its_urdf_is_refused(changes: dict[str, object], words: str) -> None:
    with pytest.raises(BadRobot, match=words):
        RobotModel(lwr(**changes), where="arm.urdf")


def test_a_home_outside_the_limits_is_refused_also_for_a_cell_made_in_memory() -> None:
    cell = load_cell(CELLS / "lwr4_bench")
    robot = cell.robot.model_copy(update={"home_rad": (0.0, 3.0, 0.0, 1.75, 0.0, -1.05, 0.0)})
    with pytest.raises(BadCell, match=r"robot.home_rad: found 3 for 'joint2'"):
        RobotModel.of_cell(cell.model_copy(update={"robot": robot}))


def test_a_urdf_is_read_once_however_many_look_at_it(monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[str] = []
    parse, build = ET.fromstring, pin.buildModelFromXML
    monkeypatch.setattr(ET, "fromstring", lambda text: (read.append("XML"), parse(text))[1])
    monkeypatch.setattr(pin, "buildModelFromXML", lambda text: (read.append("Pinocchio"), build(text))[1])
    cell = load_cell(CELLS / "lwr4_bench")
    cell = cell.model_copy(update={"urdf": cell.urdf + "<!-- never seen before -->"})
    read.clear()
    robots = [RobotModel.of_cell(cell), RobotModel.of_cell(cell)]
    UrdfTree(cell.urdf)
    RobotModel(robots[0].description)
    assert sorted(read) == ["Pinocchio", "XML"]
    robots[0].model.upperPositionLimit[0] = 0.0
    assert robots[1].model.upperPositionLimit[0] > 0.0
