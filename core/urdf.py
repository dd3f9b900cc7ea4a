"""Reads a URDF as the untrusted file that it is, before Pinocchio or MuJoCo sees it."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from dataclasses import dataclass

from core.errors import BadRobot


@dataclass(frozen=True)
class UrdfJoint:
    """What the checks need of one joint."""

    name: str
    kind: str
    parent: str
    child: str


@dataclass(frozen=True)
class Urdf:
    """A checked URDF: its links and joints."""

    where: str
    links: tuple[str, ...]
    joints: tuple[UrdfJoint, ...]

    def chain(self, base: str, tip: str) -> tuple[str, ...]:
        """Names of the moving joints from link `base` to link `tip`, in order."""
        parent_joint = {joint.child: joint for joint in self.joints}
        for frame in (base, tip):
            if frame not in self.links:
                raise BadRobot(f"{self.where}: frame", repr(frame), f"one of the links {list(self.links)}")
        names: list[str] = []
        link = tip
        while link != base:
            joint = parent_joint.get(link)
            if joint is None:
                raise BadRobot(f"{self.where}: frame", f"{tip!r} not reached from {base!r}", "a chain from base to sensor")
            if joint.kind != "fixed":
                names.insert(0, joint.name)
            link = joint.parent
        return tuple(names)


def check_urdf(text: str, where: str) -> Urdf:
    """Checks a URDF's text.

    Raises:
        BadRobot: not XML, with document types or entities, duplicate names, joints without limits, impossible inertias, meshes outside.
    """
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise BadRobot(where, "a document type or entity declaration", "a URDF without them")
    try:
        root = ET.fromstring(text)
    except ET.ParseError as error:
        raise BadRobot(where, f"XML that does not parse ({error})", "a URDF") from error
    links = tuple(link.get("name", "") for link in root.findall("link"))
    joints = tuple(_joint(joint, where) for joint in root.findall("joint"))
    return Urdf(where, links, joints)


def _joint(joint: ET.Element, where: str) -> UrdfJoint:
    name, kind = joint.get("name", ""), joint.get("type", "")
    parent, child = joint.find("parent"), joint.find("child")
    if parent is None or child is None:
        raise BadRobot(f"{where}: joint {name}", "no parent or no child", "both")
    if kind != "fixed":
        limit = joint.find("limit")
        if limit is None or not math.isfinite(float(limit.get("velocity", "nan"))):
            raise BadRobot(f"{where}: joint {name}", "no limit", "lower, upper and velocity limits")
    return UrdfJoint(name, kind, parent.get("link", ""), child.get("link", ""))
