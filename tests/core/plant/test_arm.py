from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from core.cell.cell import Cell
from core.errors import BadRobot
from core.payload.inertia import PINOCCHIO_ORDER
from core.plant.arm import Arm, arm_of_cell
from core.robot.model import RobotModel
from tests.core.plant.plant_oracle import CELLS

BRANCHED = """<robot name="branched">
  <link name="root"/>
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0 0.01 0.2" rpy="0.3 0 0"/><mass value="2"/>
    <inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.02" iyz="-0.002" izz="0.01"/></inertial></link>
  <link name="cover"><inertial><origin xyz="0.02 0 0"/><mass value="0.4"/>
    <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.002"/></inertial></link>
  <link name="flap"><inertial><mass value="0.1"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial></link>
  <link name="fore"><inertial><mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <link name="flange"/>
  <link name="ft"/>
  <joint name="mount" type="fixed"><parent link="root"/><child link="base"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.1 0.2 0.3"/></joint>
  <joint name="first" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0.1" rpy="0 0.5 0"/><axis xyz="0 0.6 0.8"/>
    <limit lower="-2" upper="2" velocity="2" effort="50"/></joint>
  <joint name="screws" type="fixed"><parent link="upper"/><child link="cover"/>
    <origin xyz="0 0.1 0.1" rpy="0 0 0.7"/></joint>
  <joint name="beside" type="revolute"><parent link="cover"/><child link="flap"/><origin xyz="0 0.1 0"/>
    <axis xyz="1 0 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="second" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0 0 0.4" rpy="-0.2 0 0.4"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" velocity="2" effort="30"/></joint>
  <joint name="weld" type="fixed"><parent link="fore"/><child link="flange"/>
    <origin xyz="0 0 0.2" rpy="0 0.3 0"/></joint>
  <joint name="ft_mount" type="fixed"><parent link="flange"/><child link="ft"/>
    <origin xyz="0 0 0.05" rpy="0 0 0.5"/></joint>
</robot>"""


def cell_with(urdf: str, folder: Path) -> Cell:
    (folder / "robot.urdf").write_text(urdf, encoding="utf-8")
    robot = {
        "base_frame": "base",
        "sensor_frame": "ft",
        "home_rad": (0.1, 0.2),
        "acceleration_rad_s2": (10.0, 10.0),
        "base": {"xyz_m": (0.5, -0.1, 0.2), "rpy_rad": (0.0, 0.1, 2.0)},
    }
    other = CELLS["ur5e_line"]
    return Cell.model_validate(
        {
            "name": "branched",
            "title": "a robot with a branch",
            "robot": robot,
            "sensor": other.sensor.model_dump(),
            "payload_box": other.payload_box.model_dump(),
            "folder": folder,
        }
    )


def sensor_pose(arm: Arm, q: np.ndarray) -> np.ndarray:
    pose = np.eye(4)
    for joint, angle in zip(arm.joints, q, strict=True):
        turn = np.eye(4)
        turn[:3, :3] = pin.exp3(joint.axis * angle)
        pose = pose @ joint.placement @ turn
    return np.asarray(pose @ arm.sensor)


def assert_is_pinocchios(arm: Arm, robot: RobotModel) -> None:
    rng = np.random.default_rng(3)
    for _ in range(20):
        q = rng.uniform(robot.lower, robot.upper)
        pin.framesForwardKinematics(robot.model, robot.data, q)
        expected = robot.data.oMf[robot.sensor_frame_id].homogeneous
        np.testing.assert_allclose(sensor_pose(arm, q), expected, atol=1e-12)
    for j, joint in enumerate(arm.joints):
        expected = robot.model.inertias[j + 1].toDynamicParameters()[PINOCCHIO_ORDER]
        np.testing.assert_allclose(joint.body.phi, expected, atol=1e-12)
    np.testing.assert_allclose(arm.effort, robot.model.upperEffortLimit)
    np.testing.assert_allclose(arm.velocity, robot.velocity)
    np.testing.assert_allclose(arm.lower, robot.lower)
    np.testing.assert_allclose(arm.upper, robot.upper)


@pytest.mark.parametrize("name", CELLS)
def test_our_reading_of_the_urdf_is_pinocchios(name):
    assert_is_pinocchios(arm_of_cell(CELLS[name]), RobotModel.of_cell(CELLS[name]))


def test_rigid_links_and_joints_beside_the_chain_are_welded_on(tmp_path):
    cell = cell_with(BRANCHED, tmp_path)
    assert_is_pinocchios(arm_of_cell(cell), RobotModel.of_cell(cell))


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        (' effort="30"', "", "second': limit"),
        ('effort="30"', 'effort="0"', "second': limit effort"),
        ('effort="30"', 'effort="-3"', "second': limit effort"),
        ('effort="30"', 'effort="nan"', "second': limit effort"),
        ('effort="30"', 'effort="1e999"', "second': limit effort"),
        ('<mass value="1"/>', '<mass value="0"/>', "second"),
        ('izz="0.01"/></inertial></link>\n  <link name="flange"/>', 'izz="0.5"/></inertial></link>\n  <link name="flange"/>', "second"),
    ],
)
def test_an_arm_that_cannot_be_driven_is_refused_with_the_joints_name(written, instead, said, tmp_path):
    assert written in BRANCHED
    cell = cell_with(BRANCHED, tmp_path)
    (tmp_path / "robot.urdf").write_text(BRANCHED.replace(written, instead), encoding="utf-8")
    with pytest.raises(BadRobot, match=said):
        arm_of_cell(cell)
