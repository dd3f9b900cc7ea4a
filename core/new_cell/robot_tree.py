"""A robot's description as a tree that can be changed: only links and joints, everything else is left out."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from copy import deepcopy
from functools import cached_property

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.urdf import Urdf, check_urdf
from core.cell.urdf_elements import UrdfJoint, parse
from core.errors import BadRobot

KEPT_OF_JOINT = ("origin", "parent", "child", "axis", "limit", "mimic")
KEPT_OF_LINK = ("inertial", "visual", "collision")
LONGEST_NAME = 200


class RobotTree:
    """Links and joints of a URDF.

    Args:
        text: the URDF.
        where: the file, for the sentence.

    Raises:
        BadRobot: what `check_urdf` says.
    """

    def __init__(self, text: str, where: str) -> None:
        self.where = where
        given = deepcopy(parse(text, where))  # what is parsed once is nobody's to change
        self.root = ET.Element("robot", name=given.get("name", ""))
        for element in given:
            if element.tag in ("link", "joint"):
                kept = KEPT_OF_LINK if element.tag == "link" else KEPT_OF_JOINT
                for part in [part for part in element if part.tag not in kept]:
                    element.remove(part)
                self.root.append(element)
        self._rename_joints_like_links()
        for name in self.checked.links:
            if not name.isprintable() or len(name) > LONGEST_NAME:
                raise BadRobot(
                    f"{where}: link", "newcell-link-name", name=name[:LONGEST_NAME].encode("unicode_escape").decode(), most=LONGEST_NAME
                )

    def _rename_joints_like_links(self) -> None:
        """A joint with the name of a link is another frame of that name, which Pinocchio cannot tell from it."""
        links = {link.get("name") for link in self.root.iter("link")}
        taken = links | {joint.get("name") for joint in self.root.iter("joint")}
        for joint in self.root.iter("joint"):
            if joint.get("name") in links:
                name = f"{joint.get('name')}_joint"
                while name in taken:
                    name += "_"
                for mimic in self.root.iter("mimic"):
                    if mimic.get("joint") == joint.get("name"):
                        mimic.set("joint", name)
                joint.set("name", name)
                taken.add(name)

    @property
    def text(self) -> str:
        """The URDF as it is now."""
        ET.indent(self.root)
        return '<?xml version="1.0"?>\n' + ET.tostring(self.root, encoding="unicode") + "\n"

    @property
    def checked(self) -> Urdf:
        """The URDF as it is now, read again.

        Raises:
            BadRobot: it cannot be used.
        """
        return check_urdf(ET.tostring(self.root, encoding="unicode"), self.where)

    @cached_property
    def parents(self) -> dict[str, UrdfJoint]:
        """The joint above each link, as the description had it."""
        return {joint.child: joint for joint in self.checked.joints}

    def link(self, name: str) -> ET.Element:
        """The element of a link."""
        return next(link for link in self.root.iter("link") if link.get("name") == name)

    def joint(self, name: str) -> ET.Element:
        """The element of a joint."""
        return next(joint for joint in self.root.iter("joint") if joint.get("name") == name)

    def path(self, link: str) -> list[UrdfJoint]:
        """Joints from the root of the tree to a link."""
        joints: list[UrdfJoint] = []
        while link in self.parents:
            joints.insert(0, self.parents[link])
            link = joints[0].parent
        return joints

    def behind(self, link: str) -> list[str]:
        """Links that hang on a link, without itself, nearest first."""
        found = [link]
        for each in found:
            found += [joint.child for joint in self.parents.values() if joint.parent == each]
        return found[1:]

    def shapes(self, link: str, kind: str) -> list[ET.Element]:
        """The `collision` or `visual` elements of a link."""
        return self.link(link).findall(kind)

    def is_body(self, link: str) -> bool:
        """Whether a link has mass or a shape."""
        mass = self.link(link).find("inertial/mass")
        has_mass = mass is not None and float(mass.get("value", "0")) > 0.0
        return has_mass or bool(self.shapes(link, "collision") or self.shapes(link, "visual"))

    def fix(self, joint: UrdfJoint, value: float) -> None:
        """Makes a joint fixed where it stands at `value` (rad or m)."""
        element = self.joint(joint.name)
        turns = joint.kind in ("revolute", "continuous")
        axis = joint.axis / max(float(np.linalg.norm(joint.axis)), 1e-12)
        if value != 0.0 and (turns or joint.kind == "prismatic"):
            origin = element.find("origin")
            if origin is None:
                origin = ET.SubElement(element, "origin")
            xyz, rpy = (np.array([float(word) for word in origin.get(key, "0 0 0").split()]) for key in ("xyz", "rpy"))
            rotation = Rotation.from_euler("xyz", rpy)
            if turns:
                rotation = rotation * Rotation.from_rotvec(value * axis)
            else:
                xyz = xyz + rotation.apply(value * axis)
            origin.set("xyz", format_numbers(xyz))
            origin.set("rpy", format_numbers(rotation.as_euler("xyz")))
        element.set("type", "fixed")
        for tag in ("axis", "limit", "mimic"):
            for part in element.findall(tag):
                element.remove(part)

    def add_link(self, name: str, on: str, xyz: Array, rpy: Array) -> None:
        """A new link without a body, fixed to another; `xyz` in m, `rpy` in rad.

        Raises:
            BadRobot: there is one of that name.
        """
        urdf = self.checked
        joint = f"{name}_joint"
        if name in urdf.links or joint in (each.name for each in urdf.joints):
            raise BadRobot(f"{self.where}: link", "newcell-link-exists", link=name)
        ET.SubElement(self.root, "link", name=name)
        element = ET.SubElement(self.root, "joint", name=joint, type="fixed")
        ET.SubElement(element, "origin", xyz=format_numbers(xyz), rpy=format_numbers(rpy))
        ET.SubElement(element, "parent", link=on)
        ET.SubElement(element, "child", link=name)
        self.__dict__.pop("parents", None)  # counted anew

    def set_limit(self, joint: str, key: str, value: float) -> None:
        """One limit of a joint, rad, rad/s or N m."""
        element = self.joint(joint)
        limit = element.find("limit")
        if limit is None:
            limit = ET.SubElement(element, "limit")
        limit.set(key, f"{value:.9g}")

    def set_inertia(self, link: str, mass: float, com: Array, inertia: Array) -> None:
        """Mass (kg), centre of mass (3,) in the link's frame (m) and inertia (3, 3) about it in the link's axes (kg m2)."""
        element = self.link(link)
        for old in element.findall("inertial"):
            element.remove(old)
        inertial = ET.SubElement(element, "inertial")
        ET.SubElement(inertial, "origin", xyz=format_numbers(com), rpy="0 0 0")
        ET.SubElement(inertial, "mass", value=f"{mass:.6g}")
        names = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
        ET.SubElement(inertial, "inertia", {name: f"{inertia[place]:.6g}" for name, place in names.items()})

    def meshes(self) -> Iterator[tuple[str, ET.Element]]:
        """Each mesh with the name of its link."""
        for link in self.root.findall("link"):
            for mesh in link.iter("mesh"):
                yield link.get("name", ""), mesh


def format_numbers(values: Array) -> str:
    """As a URDF has them."""
    return " ".join(f"{value:.12g}" for value in values + 0.0)
