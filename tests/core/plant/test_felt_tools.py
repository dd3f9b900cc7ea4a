"""What hangs behind the sensor is felt by it: compared with Pinocchio's Newton-Euler recursion on that chain alone."""

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.payload.inertia import InertialParameters
from core.plant.arm import arm_of_cell
from core.plant.virtual_robot import VirtualRobot
from core.robot.model import RobotModel
from tests.core.handed import GRIPPER, HAND, HAND_AS_TOOL, cell_folder
from tests.core.plant.plant_oracle import smooth_move

ADAPTER = GRIPPER.replace("tools.gripper", "tools.adapter")
BEHIND = '<robot name="behind"><link name="ft"/>' + HAND.format(parent="ft") + "</robot>"
NOTHING = InertialParameters(np.zeros(10))


def body(mass: float, first_moment: np.ndarray, six: np.ndarray) -> pin.Inertia:
    """From the numbers as cell.toml has them, moved to the centre of mass by the parallel-axis theorem."""
    xx, xy, xz, yy, yz, zz = six
    c = np.asarray(first_moment) / mass
    about_origin = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return pin.Inertia(mass, c, about_origin - mass * (c @ c * np.eye(3) - np.outer(c, c)))


class Behind:
    """The hand as a chain of its own that floats, the adapter and a payload welded to its root: the wrench that makes it move so."""

    def __init__(self, cell: Cell, *bodies: pin.Inertia, urdf: str = BEHIND) -> None:
        full = pin.buildModelFromXML(urdf, pin.JointModelFreeFlyer())
        sliding = [full.getJointId(name) for name in full.names[2:]]
        self.model = pin.buildReducedModel(full, sliding, pin.neutral(full))
        for each in bodies:
            self.model.appendBodyToJoint(1, each, pin.SE3.Identity())
        self.model.gravity.linear = cell.gravity
        self.data = self.model.createData()
        self.arm = RobotModel.of_cell(cell)

    def wrench(self, q: np.ndarray, dq: np.ndarray, ddq: np.ndarray) -> np.ndarray:
        model, data, frame = self.arm.model, self.arm.data, self.arm.sensor_frame_id
        pin.forwardKinematics(model, data, q, dq, ddq)
        pose = pin.updateFramePlacement(model, data, frame)
        local = pin.ReferenceFrame.LOCAL
        v, a = pin.getFrameVelocity(model, data, frame, local), pin.getFrameAcceleration(model, data, frame, local)
        return np.array(pin.rnea(self.model, self.data, pin.SE3ToXYZQUAT(pose), v.vector, a.vector)[:6])


def assert_felt(robot: VirtualRobot, behind: Behind) -> None:
    path = smooth_move(robot.home, robot.home + 0.25 * np.linspace(1.0, -1.0, robot.arm.n), 0.3)
    moving = 0.0
    for k, q_cmd in enumerate(path):
        robot.step(q_cmd)
        if k % 20 == 0:
            truth = robot.truth
            np.testing.assert_allclose(truth.wrench, behind.wrench(truth.q, truth.dq, truth.ddq), atol=1e-9)
            moving = max(moving, float(np.abs(truth.ddq).max()))
    assert moving > 1.0


def test_the_simulated_wrench_is_that_of_tools_and_payload(tmp_path: Path) -> None:
    cell = load_cell(cell_folder(tmp_path, toml=HAND_AS_TOOL + ADAPTER, hand=True))
    adapter = body(0.8, np.array([0.004, -0.002, 0.032]), np.array([0.0026, 0.0, -0.0001, 0.0027, 0.0001, 0.0012]))
    known = cell.payloads["steel_block"]
    carried = body(known.mass_kg, np.array(known.first_moment_kg_m), np.array(known.inertia_kg_m2))
    robot = VirtualRobot(cell, known.parameters, np.random.default_rng(0))
    assert_felt(robot, Behind(cell, adapter, carried))


def test_a_hand_is_felt_without_a_payload_too(tmp_path: Path) -> None:
    cell = load_cell(cell_folder(tmp_path, toml=HAND_AS_TOOL, hand=True, name="ur5e_line"))
    robot = VirtualRobot(cell, NOTHING, np.random.default_rng(0))
    assert_felt(robot, Behind(cell))
    assert robot.carried.mass == pytest.approx(0.75)


def test_the_arm_itself_is_no_heavier_for_what_hangs_behind_its_sensor(tmp_path: Path) -> None:
    """Neither in the simulation nor in Pinocchio's model: whatever the sensor feels would count twice."""
    bare, handed = (load_cell(cell_folder(tmp_path / str(hand), toml=HAND_AS_TOOL if hand else "", hand=hand)) for hand in (False, True))
    assert [joint.body.phi.tolist() for joint in arm_of_cell(bare).joints] == [
        joint.body.phi.tolist() for joint in arm_of_cell(handed).joints
    ]
    masses = [[body.mass for body in RobotModel.of_cell(cell).model.inertias] for cell in (bare, handed)]
    assert masses[0] == masses[1]
