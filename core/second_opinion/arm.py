"""The arm as the second opinion sees it: kinematics in numpy and solids, both read from the URDF's XML."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell, Pose
from core.second_opinion.solids import Solid, box, parse_vector, solids_of_geometries

PAYLOAD = "payload"


class Frames(NamedTuple):
    """Many placements: rotation (..., 3, 3) and position (..., 3), m."""

    rotation: Array
    position: Array

    def after(self, following: Frames) -> Frames:
        """Placements that are given in these frames, in the frame that these are given in."""
        return Frames(self.rotation @ following.rotation, self.position + np.einsum("...ij,...j->...i", self.rotation, following.position))

    def express_in(self, other: Frames) -> Frames:
        """These placements in other frames, both in the world."""
        back = np.swapaxes(other.rotation, -1, -2)
        return Frames(back @ self.rotation, np.einsum("...ij,...j->...i", back, self.position - other.position))


IDENTITY = Frames(np.eye(3), np.zeros(3))


@dataclass(frozen=True)
class ArmBody:
    """A convex part of the arm, the box of a tool, or the payload box.

    Args:
        name: of the link or the tool, or "payload".
        joint: how many joints of the arm move it.
        placement: in the frame after the last of them, or in the world.
        carried: whether the arm carries it, as the payload.
    """

    name: str
    joint: int
    placement: Frames
    solid: Solid
    carried: bool = False


@dataclass(frozen=True)
class SolidArm:
    """A chain of n hinges with everything that hangs on it; joints outside the chain stand at zero.

    Args:
        placements: n frames, each joint's in the previous one, the first in the world.
        axes: (n, 3), unit vectors in the joints' own frames.
        sensor: in the frame after the last joint.
        bodies: those of the links, of the tools' boxes and, last, the payload box.
        lower, upper: (n,), limits of the joints, rad.
        joined: pairs of links with bodies that one joint of the chain joins, with no other body between them.
    """

    placements: tuple[Frames, ...]
    axes: Array
    sensor: Frames
    bodies: tuple[ArmBody, ...]
    lower: Array
    upper: Array
    joined: tuple[tuple[str, str], ...]

    def frames(self, q: Array) -> list[Frames]:
        """The world's frame, then the one after each joint, at joint positions q (N, n)."""
        here = Frames(np.broadcast_to(np.eye(3), (len(q), 3, 3)), np.zeros((len(q), 3)))
        found = [here]
        for placement, axis, angle in zip(self.placements, self.axes, q.T, strict=True):
            here = here.after(placement)
            here = Frames(here.rotation @ _turns(axis, angle), here.position)
            found.append(here)
        return found

    def sensor_frames(self, q: Array) -> Frames:
        """The sensor in the world at joint positions q (N, n)."""
        return self.frames(q)[-1].after(self.sensor)


def build_solid_arm(cell: Cell, payload_box: Box) -> SolidArm:
    """The cell's robot with the boxes of its tools and a payload box, in the world frame.

    Raises:
        BadRobot: a mesh cannot be read.
    """
    root = ET.fromstring(cell.urdf)
    joints = {_link(joint, "child"): joint for joint in root.findall("joint")}
    chain = [link for link in _way(joints, cell.robot.sensor_frame, cell.robot.base_frame) if joints[link].get("type") != "fixed"]
    world = frame_of_pose(cell.robot.base).after(_inverse(_at_zero(joints, cell.robot.base_frame)))
    names = [element.get("name", "") for element in root.findall("link")]
    carried = {name: _carrier(joints, chain, world, name) for name in names}
    placements = [carried[_link(joints[link], "parent")][1].after(_origin(joints[link])) for link in chain]
    shapes = [
        (name, owner, geometry)
        for element in root.findall("link")
        for name in [element.get("name", "")]
        for owner in element.findall("visual" if name in cell.robot.visual_shapes else "collision")
        for geometry in owner.findall("geometry")
    ]
    solids = solids_of_geometries([geometry for _, _, geometry in shapes], cell.folder)
    of_tools = {link for tool in cell.tools.values() for link in tool.links or ()}
    bodies = [
        ArmBody(name, carried[name][0], carried[name][1].after(_origin(owner)), solid, name in of_tools)
        for (name, owner, _), solid in zip(shapes, solids, strict=True)
    ]
    n, sensor = carried[cell.robot.sensor_frame]
    boxes = {name: tool.box for name, tool in cell.tools.items() if tool.box is not None} | {PAYLOAD: payload_box}
    for name, each in boxes.items():
        bodies.append(ArmBody(name, n, sensor.after(frame_of_pose(each.pose)), box(np.array(each.size_m)), carried=True))
    limits = np.array(
        [[float(limit.get(key, "")) for key in ("lower", "upper")] for link in chain for limit in joints[link].findall("limit")]
    )
    axes = np.array([_axis(joints[link]) for link in chain])
    lower, upper = limits.T
    return SolidArm(
        tuple(placements), axes, sensor, tuple(bodies), lower, upper, _find_joined_links(joints, chain, {body.name for body in bodies})
    )


def _find_joined_links(joints: dict[str, ET.Element], chain: list[str], solid: set[str]) -> tuple[tuple[str, str], ...]:
    """Pairs of links with a solid that are joined by one joint of the chain; links without a solid between them do not count."""
    found = []
    for link in solid & set(joints):
        upwards = [link]
        while upwards[-1] in joints and (len(upwards) == 1 or upwards[-1] not in solid):
            upwards.append(_link(joints[upwards[-1]], "parent"))
        if upwards[-1] in solid and sum(each in chain for each in upwards[:-1]) == 1:
            found.append((link, upwards[-1]))
    return tuple(found)


def frame_of_pose(pose: Pose) -> Frames:
    """A pose of cell.toml as a frame."""
    return Frames(_rpy(*pose.rpy_rad), np.array(pose.xyz_m))


def _carrier(joints: dict[str, ET.Element], chain: list[str], world: Frames, link: str) -> tuple[int, Frames]:
    """How many joints of the chain move a link, and where it is in the frame after the last of them."""
    placement = IDENTITY
    while link not in chain:
        if link not in joints:
            return 0, world.after(placement)
        placement = _origin(joints[link]).after(placement)
        link = _link(joints[link], "parent")
    return chain.index(link) + 1, placement


def _way(joints: dict[str, ET.Element], tip: str, base: str) -> list[str]:
    """The links after `base` on the way to `tip`."""
    links: list[str] = []
    while tip != base:
        links.insert(0, tip)
        tip = _link(joints[tip], "parent")
    return links


def _at_zero(joints: dict[str, ET.Element], link: str) -> Frames:
    """A link in the root link where every joint stands at zero."""
    placement = IDENTITY
    while link in joints:
        placement = _origin(joints[link]).after(placement)
        link = _link(joints[link], "parent")
    return placement


def _link(joint: ET.Element, end: str) -> str:
    return next(element.get("link", "") for element in joint.findall(end))


def _origin(owner: ET.Element) -> Frames:
    """Of a joint or a collision body."""
    for origin in owner.findall("origin"):
        return Frames(_rpy(*parse_vector(origin.get("rpy", "0 0 0"))), parse_vector(origin.get("xyz", "0 0 0")))
    return IDENTITY


def _axis(joint: ET.Element) -> Array:
    """(3,), unit vector."""
    direction = np.array([1.0, 0.0, 0.0])
    for axis in joint.findall("axis"):
        direction = parse_vector(axis.get("xyz", "1 0 0"))
    return np.asarray(direction / np.linalg.norm(direction))


def _inverse(frame: Frames) -> Frames:
    return Frames(frame.rotation.T, -frame.rotation.T @ frame.position)


def _rpy(roll: float, pitch: float, yaw: float) -> Array:
    """(3, 3), about the fixed axes x, y, z in that order."""
    turns = [_turns(np.eye(3)[k], np.array([angle]))[0] for k, angle in enumerate((roll, pitch, yaw))]
    return np.asarray(turns[2] @ turns[1] @ turns[0])


def _turns(axis: Array, angle: Array) -> Array:
    """(N, 3, 3), rotations about a unit axis (Rodrigues' formula)."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    sine, versine = np.sin(angle)[:, None, None], (1.0 - np.cos(angle))[:, None, None]
    return np.asarray(np.eye(3) + sine * cross + versine * (cross @ cross))
