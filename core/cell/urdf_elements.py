"""The elements of a URDF, read as untrusted text: numbers, shapes, links and joints, each checked by itself."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from core.array import Array
from core.errors import BadRobot
from core.payload.inertia import symmetric

MAX_BYTES = 5_000_000
MAX_DEPTH = 32

KINDS = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
SIZES = {"box": ("size", 3), "cylinder": ("radius length", 1), "sphere": ("radius", 1), "capsule": ("radius length", 1)}
LIMITS = ("lower", "upper", "velocity", "effort")
INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)


@dataclass(frozen=True)
class UrdfShape:
    """What a <collision> or a <visual> of a link holds.

    Args:
        kind: box, cylinder, sphere, capsule or mesh.
        sizes: edges of a box; radius and length along z; radius; m. Factors along the axes of a mesh.
        file: of a mesh, else empty.
        xyz, rpy: (3,), its place in the link's frame, m, and its turns about the fixed axes, rad.
    """

    kind: str
    sizes: tuple[float, ...]
    file: str
    xyz: Array
    rpy: Array


@dataclass(frozen=True)
class UrdfLink:
    """One body.

    Args:
        mass: kg, None where the URDF gives no inertial.
        inertia: (3, 3) about the centre of mass, kg m2, None where not given.
        collision: what may run into something.
        visual: what it looks like.
    """

    name: str
    mass: float | None
    inertia: Array | None
    collision: tuple[UrdfShape, ...] = ()
    visual: tuple[UrdfShape, ...] = ()


@dataclass(frozen=True)
class UrdfJoint:
    """One joint; limits are None where the URDF gives none.

    Args:
        axis: (3,), as written.
        lower, upper: rad. velocity: rad/s. effort: N m.
    """

    name: str
    kind: str
    parent: str
    child: str
    axis: Array
    lower: float | None
    upper: float | None
    velocity: float | None
    effort: float | None
    mimic: bool


@lru_cache(maxsize=8)
def read_xml(text: str) -> ET.Element:
    """The root element of a text, parsed once for all who look at it; nobody changes it."""
    return ET.fromstring(text)


def parse(text: str, where: str) -> ET.Element:
    """The root element <robot>; raises BadRobot for what is no such XML."""
    if len(text) > MAX_BYTES:
        raise BadRobot(where, "description-too-long", characters=len(text), most=MAX_BYTES)
    for declaration in ("<!DOCTYPE", "<!ENTITY"):
        if declaration in text:
            raise BadRobot(where, "description-declaration", declaration=declaration)
    try:
        root = read_xml(text)
    except (ET.ParseError, ValueError, LookupError) as error:
        raise BadRobot(where, "description-no-xml", reason=str(error)) from error
    if root.tag != "robot":
        raise BadRobot(where, "description-of-no-robot", tag=root.tag)
    if not root.get("name"):
        raise BadRobot(where, "description-robot-without-name")
    return root


def check_elements(root: ET.Element, where: str) -> None:
    """Depth, inclusions and every number in the file that has a size or a place."""
    level, depth = [root], 0
    while level:
        level, depth = [child for element in level for child in element], depth + 1
        if depth > MAX_DEPTH:
            raise BadRobot(where, "description-too-deep", most=MAX_DEPTH)
    for element in root.iter():
        tag = str(element.tag)
        if "xacro" in tag or tag.rpartition("}")[2] == "include":
            raise BadRobot(where, "description-incomplete", tag=tag)
    for owner in (*root.findall("link"), *root.findall("joint")):
        owner_where = f"{where}: {owner.tag} {owner.get('name', '')!r}"
        for origin in owner.iter("origin"):
            for key in ("xyz", "rpy"):
                _numbers(origin, key, 3, owner_where, "0 0 0")
        for geometry in owner.iter("geometry"):
            _check_geometry(geometry, owner_where)


def _check_geometry(geometry: ET.Element, where: str) -> None:
    shapes = list(geometry)
    kinds = (*SIZES, "mesh")
    if not shapes:
        raise BadRobot(f"{where}: geometry", "description-no-shape", kinds=kinds)
    if len(shapes) != 1 or shapes[0].tag not in kinds:
        raise BadRobot(f"{where}: geometry", "description-unknown-shape", shapes=[shape.tag for shape in shapes], kinds=kinds)
    shape = shapes[0]
    if shape.tag == "mesh":
        _numbers(shape, "scale", 3, f"{where}: mesh", "1 1 1")
        if not shape.get("filename"):
            raise BadRobot(f"{where}: mesh", "description-mesh-without-file")
        return
    keys, count = SIZES[shape.tag]
    for key in keys.split():
        size = _numbers(shape, key, count, f"{where}: {shape.tag}")
        if (size <= 0).any():
            raise BadRobot(f"{where}: {shape.tag} {key}", "description-size-not-positive", sizes=shape.get(key, ""))


def read_link(link: ET.Element, where: str) -> UrdfLink:
    """A link with its shapes and with its mass and inertia, neither of them negative; `check_elements` has seen it."""
    name = link.get("name", "")
    where = f"{where}: link {name!r}"
    collision, visual = (tuple(_read_shapes(link, kind, where)) for kind in ("collision", "visual"))
    inertial = link.find("inertial")
    if inertial is None:
        return UrdfLink(name, None, None, collision, visual)
    mass_element, inertia_element = inertial.find("mass"), inertial.find("inertia")
    if mass_element is None:
        raise BadRobot(f"{where}: inertial", "description-without-mass")
    if inertia_element is None:
        raise BadRobot(f"{where}: inertial", "description-without-inertia")
    mass = float(_numbers(mass_element, "value", 1, f"{where}: mass")[0])
    if mass < 0:
        raise BadRobot(f"{where}: mass", "description-negative-mass", mass_kg=mass)
    six = [float(_numbers(inertia_element, key, 1, f"{where}: inertia")[0]) for key in INERTIA]
    if min(six[0], six[3], six[5]) < 0:
        raise BadRobot(f"{where}: inertia", "description-negative-moment", ixx_kg_m2=six[0], iyy_kg_m2=six[3], izz_kg_m2=six[5])
    return UrdfLink(name, mass, symmetric(six), collision, visual)


def _read_shapes(link: ET.Element, kind: str, where: str) -> Iterator[UrdfShape]:
    for owner in link.findall(kind):
        origin = owner.find("origin")
        xyz, rpy = (np.zeros(3) if origin is None else _numbers(origin, key, 3, where, "0 0 0") for key in ("xyz", "rpy"))
        for shape in (geometry[0] for geometry in owner.findall("geometry")):
            keys, count = SIZES.get(shape.tag, ("scale", 3))
            sizes = [float(size) for key in keys.split() for size in _numbers(shape, key, count, where, "1 1 1")]
            yield UrdfShape(shape.tag, tuple(sizes), shape.get("filename", ""), xyz, rpy)


def read_joint(joint: ET.Element, where: str) -> UrdfJoint:
    """A joint with its ends, axis and limits."""
    name, kind = joint.get("name", ""), joint.get("type", "")
    where = f"{where}: joint {name!r}"
    if kind not in KINDS:
        raise BadRobot(f"{where}: type", "description-unknown-joint-type", type=kind, types=KINDS)
    ends = [_end(joint, key, where) for key in ("parent", "child")]
    axis = joint.find("axis")
    limit = joint.find("limit")
    lower, upper, velocity, effort = (_optional_number(limit, key, where) for key in LIMITS)
    direction = np.array([1.0, 0.0, 0.0]) if axis is None else _numbers(axis, "xyz", 3, f"{where}: axis", "1 0 0")
    mimic = joint.find("mimic") is not None
    return UrdfJoint(name, kind, ends[0], ends[1], direction, lower, upper, velocity, effort, mimic)


def _end(joint: ET.Element, key: str, where: str) -> str:
    element = joint.find(key)
    if element is None or not element.get("link"):
        raise BadRobot(f"{where}: {key}", "description-joint-without-link")
    return element.get("link", "")


def _numbers(element: ET.Element, key: str, count: int, where: str, default: str | None = None) -> Array:
    """The attribute's numbers, (count,); plain decimal notation, since other readers disagree about everything else."""
    text = element.get(key, default)
    if text is None:
        raise BadRobot(f"{where} {key}", "description-no-value", count=count)
    words = text.split()
    if len(words) != count or not all(_NUMBER.fullmatch(word) for word in words):
        raise BadRobot(f"{where} {key}", "description-no-number", text=text[:60], count=count)
    values = np.array([float(word) for word in words])
    if not (np.abs(values) < 1e4).all():  # metres, radians, kilograms of a robot cell
        raise BadRobot(f"{where} {key}", "description-too-far", text=text[:60])
    return values


def _optional_number(limit: ET.Element | None, key: str, where: str) -> float | None:
    if limit is None or limit.get(key) is None:
        return None
    return float(_numbers(limit, key, 1, f"{where}: limit")[0])
