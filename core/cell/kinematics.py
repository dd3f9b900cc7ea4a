"""Which robot it is: where its joints' axes lie at zero, whatever its links are called and however its file is written."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence

import numpy as np

from core.array import Array
from core.cell.urdf_elements import check_elements, parse
from core.payload.rotations import rotation_of_rpy

Axes = list[list[float]]
"""Direction (3) and moment (3, m) of each joint's axis in the base frame, all joints at zero."""

ALIKE = 0.01
"""Of directions, and of moments in m: calibrated robots of one type differ by millimetres, types by centimetres."""


def joint_axes(urdf: str, joints: Sequence[str], base: str, where: str) -> Axes:
    """The axes of some joints of a URDF; those that it does not have are left out.

    Args:
        base: the link in whose frame the axes are told.
        where: the file, for errors.

    Raises:
        BadRobot: no such file.
    """
    root = parse(urdf, where)
    check_elements(root, where)
    elements = root.findall("joint")
    above = {_link(joint, "child"): joint for joint in elements}
    named = {joint.get("name"): joint for joint in elements}
    return [_axis(named[name], above, base) for name in joints if name in named]


def is_same_robot(one: Axes, other: Axes) -> bool:
    """Whether both have as many joints, and their axes lie in the same places."""
    return len(one) == len(other) and bool(np.allclose(np.array(one), np.array(other), rtol=0.0, atol=ALIKE))


def _axis(joint: ET.Element, above: dict[str, ET.Element], base: str) -> list[float]:
    written = _read(joint.find("axis"), "xyz", "1 0 0")
    axis, position = written / max(float(np.linalg.norm(written)), 1e-12), np.zeros(3)
    for each in _climb(joint, above, base):
        origin = each.find("origin")
        R = rotation_of_rpy(_read(origin, "rpy", "0 0 0"))
        axis, position = R @ axis, R @ position + _read(origin, "xyz", "0 0 0")
    return [*axis.tolist(), *np.cross(position, axis).tolist()]


def _climb(joint: ET.Element, above: dict[str, ET.Element], base: str) -> Iterator[ET.Element]:
    """A joint and those above it, up to the base; each once, whatever the file says."""
    passed: set[str] = set()
    here: ET.Element | None = joint
    while here is not None:
        yield here
        parent = _link(here, "parent")
        here = None if parent == base or parent in passed else above.get(parent)
        passed.add(parent)


def _link(joint: ET.Element, end: str) -> str:
    element = joint.find(end)
    return "" if element is None else element.get("link", "")


def _read(element: ET.Element | None, key: str, default: str) -> Array:
    text = default if element is None else element.get(key, default)
    return np.array([float(word) for word in text.split()])
