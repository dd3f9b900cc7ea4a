"""The arm as the plant needs it: joints in a row, each with the bodies that hang rigidly on it. Read from the checked
URDF.

MuJoCo never sees the URDF itself, so it can follow no file that the URDF names; and Pinocchio, which reads the same
text for planning, stays an independent opinion.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.urdf import Hinge, check_urdf
from core.cell.urdf_tree import UrdfTree, axis_of, end_of, origin_of
from core.errors import BadPayload, BadRobot
from core.payload.inertia import InertialParameters
from core.plant.principal import principal_inertia
from core.words.message import Message


@dataclass(frozen=True)
class ArmJoint:
    """One revolute joint and everything that moves rigidly with it, up to the next.

    Args:
        name: of the joint.
        placement: (4, 4), this joint's frame in the previous joint's (the first: in the world).
        axis: (3,), unit vector in this joint's frame.
        body: inertial parameters of all links that move with it, in this joint's frame; not of those behind the sensor, which it feels.
        lower, upper: position limits, rad.
        velocity: limit, rad/s.
        effort: torque limit, N m.
    """

    name: str
    placement: Array
    axis: Array
    body: InertialParameters
    lower: float
    upper: float
    velocity: float
    effort: float


@dataclass(frozen=True)
class Arm:
    """The chain from the world to the sensor.

    Args:
        joints: in order.
        sensor: (4, 4), sensor frame in the last joint's frame.
    """

    joints: tuple[ArmJoint, ...]
    sensor: Array

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joints)

    @property
    def lower(self) -> Array:
        """(n,), rad."""
        return np.array([joint.lower for joint in self.joints])

    @property
    def upper(self) -> Array:
        """(n,), rad."""
        return np.array([joint.upper for joint in self.joints])

    @property
    def velocity(self) -> Array:
        """(n,), rad/s."""
        return np.array([joint.velocity for joint in self.joints])

    @property
    def effort(self) -> Array:
        """(n,), N m."""
        return np.array([joint.effort for joint in self.joints])


def arm_of_cell(cell: Cell) -> Arm:
    """The cell's arm, placed in the world by `cell.robot.base`. Joints beside the chain stay at zero.

    Raises:
        BadRobot: the URDF cannot be used, or a joint of the chain has no torque limit.
    """
    where = str(cell.folder / cell.robot.urdf)
    urdf = check_urdf(cell.urdf, where)
    hinges = urdf.hinges(cell.robot.base_frame, cell.robot.sensor_frame)
    effort = {joint.name: joint.effort for joint in urdf.joints}
    tree = UrdfTree(cell.urdf, (hinge.name for hinge in hinges))
    carried = tree.behind(cell.robot.sensor_frame)

    at_base = np.eye(4)
    at_base[:3, :3], at_base[:3, 3] = cell.robot.base.rotation, cell.robot.base.translation
    previous = at_base @ np.linalg.inv(tree.find_rigid_parent(cell.robot.base_frame)[1])
    joints = []
    for hinge in hinges:
        tag = tree.joints[hinge.name]
        _, on_previous = tree.find_rigid_parent(end_of(tag, "parent"))
        joints.append(
            ArmJoint(
                name=hinge.name,
                placement=previous @ on_previous @ origin_of(tag),
                axis=axis_of(tag),
                body=_body(tree, hinge, carried, where),
                lower=hinge.lower,
                upper=hinge.upper,
                velocity=hinge.velocity,
                effort=_torque_limit(effort[hinge.name], Message.of("plant-effort-of-joint", file=where, joint=hinge.name)),
            )
        )
        previous = np.eye(4)
    return Arm(tuple(joints), tree.find_rigid_parent(cell.robot.sensor_frame)[1])


def _body(tree: UrdfTree, hinge: Hinge, carried: tuple[str, ...], where: str) -> InertialParameters:
    body = tree.rigid_body(hinge.child, without=carried)
    try:
        principal_inertia(body)
    except BadPayload as error:
        on_joint = Message.of("plant-links-on-joint", file=where, joint=hinge.name)
        raise BadRobot(on_joint, "plant-no-rigid-body", phi=body.phi.tolist()) from error
    return body


def _torque_limit(effort: float | None, where: Message) -> float:
    if effort is None:
        raise BadRobot(where, "plant-no-effort")
    if effort <= 0:
        raise BadRobot(where, "plant-effort-not-positive", effort_n_m=effort)
    return effort
