"""The arm as the plant needs it: joints in a row, each with the bodies that hang rigidly on it. Read from the checked
URDF.

MuJoCo never sees the URDF itself, so it can follow no file that the URDF names; and Pinocchio, which reads the same
text for planning, stays an independent opinion.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.cell import Cell
from core.errors import BadPayload, BadRobot
from core.inertia import InertialParameters
from core.plant.principal import principal_inertia
from core.urdf import Hinge, check_urdf

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ArmJoint:
    """One revolute joint and everything that moves rigidly with it, up to the next.

    Args:
        name: of the joint.
        placement: (4, 4), this joint's frame in the previous joint's (the first: in the world).
        axis: (3,), unit vector in this joint's frame.
        body: inertial parameters of all links that move with it, in this joint's frame.
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
    tree = _Tree(ET.fromstring(cell.urdf), {hinge.name for hinge in hinges})

    at_base = np.eye(4)
    at_base[:3, :3], at_base[:3, 3] = cell.robot.base.rotation, cell.robot.base.translation
    previous = at_base @ np.linalg.inv(tree.fixed_pose(cell.robot.base_frame)[1])
    joints = []
    for hinge in hinges:
        tag = tree.joints[hinge.name]
        _, on_previous = tree.fixed_pose(_link(tag, "parent"))
        joints.append(
            ArmJoint(
                name=hinge.name,
                placement=previous @ on_previous @ _origin(tag),
                axis=_axis(tag),
                body=_body(tree, hinge, where),
                lower=hinge.lower,
                upper=hinge.upper,
                velocity=hinge.velocity,
                effort=_torque_limit(effort[hinge.name], f"{where}: joint {hinge.name!r}"),
            )
        )
        previous = np.eye(4)
    return Arm(tuple(joints), tree.fixed_pose(cell.robot.sensor_frame)[1])


class _Tree:
    """The URDF's links and joints; every joint that is not in `moving` is rigid, at zero."""

    def __init__(self, root: ET.Element, moving: set[str]) -> None:
        self.joints = {joint.get("name", ""): joint for joint in root.findall("joint")}
        self._links = {link.get("name", ""): link for link in root.findall("link")}
        self._above = {_link(joint, "child"): joint for joint in self.joints.values()}
        self._moving = moving

    def fixed_pose(self, link: str) -> tuple[str, Array]:
        """The link (root, or child of a moving joint) that this one is rigidly fixed to, and the pose (4, 4) in it."""
        pose = np.eye(4)
        while (joint := self._above.get(link)) is not None and joint.get("name") not in self._moving:
            pose = _origin(joint) @ pose
            link = _link(joint, "parent")
        return link, pose

    def rigid_body(self, top: str) -> InertialParameters:
        """All links that are rigidly fixed to link `top`, in its frame."""
        phi = np.zeros(10)
        for name, link in self._links.items():
            holder, pose = self.fixed_pose(name)
            if holder == top:
                phi = phi + _link_parameters(link).moved(pose[:3, :3], pose[:3, 3]).phi
        return InertialParameters(phi)


def _body(tree: _Tree, hinge: Hinge, where: str) -> InertialParameters:
    body = tree.rigid_body(hinge.child)
    try:
        principal_inertia(body)
    except BadPayload as error:
        raise BadRobot(f"{where}: links on joint {hinge.name!r}", error.found, error.expected) from error
    return body


def _torque_limit(effort: float | None, where: str) -> float:
    if effort is None or effort <= 0:
        raise BadRobot(f"{where}: limit effort", str(effort), "a torque above 0 N m for the simulated drive")
    return effort


def _axis(joint: ET.Element) -> Array:
    """(3,), unit vector; x where the URDF names none."""
    tag = joint.find("axis")
    axis = np.array([1.0, 0.0, 0.0]) if tag is None else _numbers(tag.get("xyz", "1 0 0"))
    return np.asarray(axis / np.linalg.norm(axis))


def _link(joint: ET.Element, end: str) -> str:
    tag = joint.find(end)
    return "" if tag is None else tag.get("link", "")


def _numbers(text: str) -> Array:
    return np.array([float(number) for number in text.split()])


def _origin(tag: ET.Element) -> Array:
    """(4, 4) of a tag's `<origin>`: roll, pitch, yaw about the fixed axes."""
    pose = np.eye(4)
    origin = tag.find("origin")
    if origin is not None:
        pose[:3, :3] = Rotation.from_euler("xyz", _numbers(origin.get("rpy", "0 0 0"))).as_matrix()
        pose[:3, 3] = _numbers(origin.get("xyz", "0 0 0"))
    return pose


def _link_parameters(link: ET.Element) -> InertialParameters:
    """A link's inertial parameters in the link's frame; zero without an `<inertial>`."""
    tag = link.find("inertial")
    mass_tag, inertia_tag = (None, None) if tag is None else (tag.find("mass"), tag.find("inertia"))
    if tag is None or mass_tag is None or inertia_tag is None:
        return InertialParameters(np.zeros(10))
    ixx, ixy, ixz, iyy, iyz, izz = (float(inertia_tag.get(key, "0")) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    inertia_com = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    pose = _origin(tag)
    at_com = InertialParameters.from_com(float(mass_tag.get("value", "0")), np.zeros(3), inertia_com)
    return at_com.moved(pose[:3, :3], pose[:3, 3])
