"""Where a URDF's links are and what they weigh, read from its XML: every joint that is not said to move stands at zero.

The text has been checked (`core.cell.urdf.check_urdf`). Nothing here is Pinocchio's, which reads the same text for planning.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from copy import deepcopy

import numpy as np

from core.array import Array
from core.cell.urdf_elements import read_xml
from core.payload.inertia import InertialParameters
from core.payload.rotations import rotation_of_rpy


class UrdfTree:
    """The URDF's links and joints.

    Args:
        text: of a checked URDF.
        moving: names of the joints that move; every other one is rigid, at zero.
    """

    def __init__(self, text: str, moving: Iterable[str] = ()) -> None:
        root = read_xml(text)
        self.joints = {joint.get("name", ""): joint for joint in root.findall("joint")}
        self.links = {link.get("name", ""): link for link in root.findall("link")}
        self._above = {end_of(joint, "child"): joint for joint in self.joints.values()}
        self._moving = set(moving)

    def find_rigid_parent(self, link: str) -> tuple[str, Array]:
        """The link (root, or child of a moving joint) that this one is rigidly fixed to, and the pose (4, 4) in it."""
        pose = np.eye(4)
        while (joint := self._above.get(link)) is not None and joint.get("name") not in self._moving:
            pose = origin_of(joint) @ pose
            link = end_of(joint, "parent")
        return link, pose

    def behind(self, link: str) -> tuple[str, ...]:
        """The links that hang on this one, directly or through others, in the URDF's order; not itself."""
        below: dict[str, list[str]] = {}
        for joint in self.joints.values():
            below.setdefault(end_of(joint, "parent"), []).append(end_of(joint, "child"))
        found, open_links = set(), [link]
        while open_links:
            children = below.get(open_links.pop(), [])
            found.update(children)
            open_links += children
        return tuple(name for name in self.links if name in found)

    def rigid_body(self, top: str, without: Iterable[str] = ()) -> InertialParameters:
        """All links that are rigidly fixed to link `top`, in its frame; but for those in `without`."""
        left_out = set(without)
        held = [name for name in self.links if name not in left_out and self.find_rigid_parent(name)[0] == top]
        return self._sum(held, np.eye(4))

    def merge_links(self, frame: str, links: Iterable[str]) -> InertialParameters:
        """Links as one rigid body in the frame of link `frame`, all joints between them at zero."""
        return self._sum(links, np.asarray(np.linalg.inv(self._at_zero(frame))), at_zero=True)

    def has_body(self, link: str) -> bool:
        """Whether a link has a mass or a shape."""
        tag = self.links[link]
        return tag.find("collision") is not None or tag.find("visual") is not None or link_parameters(tag).mass > 0

    def _sum(self, links: Iterable[str], frame: Array, *, at_zero: bool = False) -> InertialParameters:
        phi = np.zeros(10)
        for name in links:
            pose = frame @ (self._at_zero(name) if at_zero else self.find_rigid_parent(name)[1])
            phi = phi + link_parameters(self.links[name]).to_frame(pose[:3, :3], pose[:3, 3]).phi
        return InertialParameters(phi)

    def _at_zero(self, link: str) -> Array:
        """Pose (4, 4) of a link in the root link, every joint at zero."""
        pose = np.eye(4)
        while (joint := self._above.get(link)) is not None:
            pose = origin_of(joint) @ pose
            link = end_of(joint, "parent")
        return pose


def without_inertia(text: str, links: Iterable[str]) -> str:
    """The URDF with some links massless; the same text where there are none."""
    bare = set(links)
    if not bare:
        return text
    root = deepcopy(read_xml(text))
    for link in root.findall("link"):
        for inertial in link.findall("inertial") if link.get("name") in bare else []:
            link.remove(inertial)
    return ET.tostring(root, encoding="unicode")


def end_of(joint: ET.Element, end: str) -> str:
    """Name of a joint's `parent` or `child`."""
    tag = joint.find(end)
    return "" if tag is None else tag.get("link", "")


def axis_of(joint: ET.Element) -> Array:
    """(3,), unit vector; x where the URDF names none."""
    tag = joint.find("axis")
    axis = np.array([1.0, 0.0, 0.0]) if tag is None else _numbers(tag.get("xyz", "1 0 0"))
    return np.asarray(axis / np.linalg.norm(axis))


def origin_of(tag: ET.Element) -> Array:
    """(4, 4) of a tag's `<origin>`: roll, pitch, yaw about the fixed axes."""
    pose = np.eye(4)
    origin = tag.find("origin")
    if origin is not None:
        pose[:3, :3] = rotation_of_rpy(_numbers(origin.get("rpy", "0 0 0")))
        pose[:3, 3] = _numbers(origin.get("xyz", "0 0 0"))
    return pose


def link_parameters(link: ET.Element) -> InertialParameters:
    """A link's inertial parameters in the link's frame; zero without an `<inertial>`."""
    tag = link.find("inertial")
    mass_tag, inertia_tag = (None, None) if tag is None else (tag.find("mass"), tag.find("inertia"))
    if tag is None or mass_tag is None or inertia_tag is None:
        return InertialParameters(np.zeros(10))
    ixx, ixy, ixz, iyy, iyz, izz = (float(inertia_tag.get(key, "0")) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    inertia_com = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    pose = origin_of(tag)
    at_com = InertialParameters.from_com(float(mass_tag.get("value", "0")), np.zeros(3), inertia_com)
    return at_com.to_frame(pose[:3, :3], pose[:3, 3])


def _numbers(text: str) -> Array:
    return np.array([float(number) for number in text.split()])
