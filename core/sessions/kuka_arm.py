"""Whether the arm behind a Fast Robot Interface is the cell's. Its messages name neither model nor serial number nor version.

What can be held against the cell instead: the number of joints, where they stand, and the flange. FRI 2 tells the pose of the tool centre
point in every message; for FRI 1 a person reads one pose off the smartPAD.
"""

from __future__ import annotations

from itertools import combinations_with_replacement

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import KukaRobot, PadPose
from core.errors import BadCell, NotConnected, WrongRobot
from core.robot.model import RobotModel
from core.sessions.controller import ANGLE_RAD, POSITION_M, Kinematics
from core.sessions.kuka_messages import METRE, Sample

BEYOND_RAD = 0.01
"""A joint may stand so far outside of the URDF's limits, for its encoder's sake."""

Pose = tuple[Array, Array]
"""Position (3,), m, and rotation (3, 3)."""


def link_of(cell: Cell) -> KukaRobot:
    """What the cell says of the line."""
    assert isinstance(cell.session, KukaRobot)
    return cell.session


def flange_of(cell: Cell, pose: Pose) -> Pose:
    """The flange whose tool centre point is at `pose`."""
    tool = link_of(cell).tool
    rotation = pose[1] @ tool.rotation.T
    return pose[0] - rotation @ tool.translation, rotation


def check_arm(cell: Cell, robot: RobotModel, kinematics: Kinematics, sample: Sample) -> None:
    """Joints, kinematics, joint positions and rate, in this order.

    Raises:
        WrongRobot: it is not the cell's arm.
        BadCell: there is no pose that it could be known by, or one that does not tell its joints apart.
        NotConnected: it sends at another rate.
    """
    link = link_of(cell)
    if not sample.joints == sample.q.size == robot.n:
        raise WrongRobot("session-wrong-joint-count", found=sample.q.size, expected=robot.n)
    if sample.pose is not None:
        kinematics.check(sample.q, *flange_of(cell, sample.pose))
    if link.pad is not None:
        _check_pad(cell, robot, kinematics, link.pad)
    elif sample.pose is None:
        raise BadCell(cell.locate("session.pad"), "kuka-no-pad")
    beyond = np.maximum(robot.lower - sample.q, sample.q - robot.upper)
    j = int(np.argmax(beyond))
    if beyond[j] > BEYOND_RAD:
        limit = float(np.clip(sample.q[j], robot.lower[j], robot.upper[j]))
        raise WrongRobot("kuka-joint-beyond", joint=robot.description.joints[j], found=float(sample.q[j]), expected=limit)
    if sample.period_ms != link.send_period_ms:
        raise NotConnected("kuka-period", host=link.host, found_s=1e-3 * sample.period_ms, expected_s=1e-3 * link.send_period_ms)
    if sample.multiplier > 1:
        raise NotConnected("kuka-multiplier", host=link.host, found=sample.multiplier)


def _check_pad(cell: Cell, robot: RobotModel, kinematics: Kinematics, pad: PadPose) -> None:
    """The cell's flange at the joints of the smartPAD is where that shows it, and would be elsewhere with any two joints swapped or any
    one turned round."""
    if robot.n != len(pad.q_deg):
        raise WrongRobot("session-wrong-joint-count", found=len(pad.q_deg), expected=robot.n)
    q, position = np.radians(pad.q_deg), METRE * np.array(pad.xyz_mm)
    rotation = Rotation.from_euler("ZYX", pad.abc_deg, degrees=True).as_matrix()
    kinematics.check(q, position, rotation)
    names = robot.description.joints
    for i, j in combinations_with_replacement(range(robot.n), 2):
        mistaken = q.copy()
        mistaken[[i, j]] = -q[i] if i == j else q[[j, i]]
        far, turned = kinematics.distance(mistaken, position, rotation)
        if far <= 2 * POSITION_M and turned <= 2 * ANGLE_RAD:
            code = "kuka-pad-hides-sign" if i == j else "kuka-pad-hides-order"
            raise BadCell(cell.locate("session.pad"), code, first=names[i], second=names[j])
