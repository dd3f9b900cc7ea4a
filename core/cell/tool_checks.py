"""What is wrong with a cell's tools: by themselves, beside the links of the URDF, or as a weight on sensor and drives."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from core.cell.contradictions import Contradiction, load_contradictions
from core.cell.tool import STATED
from core.cell.urdf import Urdf
from core.cell.urdf_tree import UrdfTree, axis_of, end_of, origin_of
from core.payload.inertia import InertialParameters, pseudo_inertia
from core.payload.rotations import rotation_of

if TYPE_CHECKING:
    from core.cell.cell import Cell, Tool

Array = NDArray[np.float64]


HARDLY_NEGATIVE = 1e-6
"""Of the largest eigenvalue: values are written with six digits."""


def tool_flaws(cell: Cell, urdf: Urdf) -> Iterator[Contradiction]:
    """Everything that speaks against the tools of a cell whose URDF has been checked; the sums only where nothing else does.

    The links behind the sensor frame that have a mass or a shape belong to tools: a sensor feels them, and an arm does not.
    """
    tree = UrdfTree(cell.urdf)
    behind = tree.behind(cell.robot.sensor_frame)
    found = list(_link_flaws(cell, tree, behind))
    for name, tool in cell.tools.items():
        found += _name_flaws(cell, name, urdf.links)
        found += _tool_flaws(f"tools.{name}", tool, cell, tree, behind)
    yield from found
    if cell.tools and not found:
        tools = tool_parameters(cell)
        heavy = list(_weight_flaws(cell, tools))
        yield from heavy or _effort_flaws(cell, urdf, InertialParameters(sum((each.phi for each in tools.values()), start=np.zeros(10))))


def tool_parameters(cell: Cell) -> dict[str, InertialParameters]:
    """The ten parameters of each tool, sensor frame, about the sensor origin; of tools that `tool_flaws` finds right."""
    tree = UrdfTree(cell.urdf) if any(tool.links for tool in cell.tools.values()) else None
    return {name: _parameters(tool, cell.robot.sensor_frame, tree) for name, tool in cell.tools.items()}


def _is_nearly_consistent(parameters: InertialParameters) -> bool:
    """Whether a body can have the parameters, if need be a point or a rod: descriptions of robots state such links."""
    lowest, *_, highest = np.linalg.eigvalsh(pseudo_inertia(parameters.phi))
    return bool(lowest >= -HARDLY_NEGATIVE * highest)


def _parameters(tool: Tool, sensor_frame: str, tree: UrdfTree | None) -> InertialParameters:
    if tool.links is not None and tree is not None:
        return tree.merge_links(sensor_frame, tool.links)
    return InertialParameters(np.array([tool.mass_kg, *(tool.first_moment_kg_m or ()), *(tool.inertia_kg_m2 or ())]))


def _name_flaws(cell: Cell, name: str, links: tuple[str, ...]) -> Iterator[Contradiction]:
    """Bodies are told apart by their names."""
    if name in {obstacle.name for obstacle in cell.obstacles} | {zone.name for zone in cell.zones}:
        yield Contradiction(f"tools.{name}", "the name of an obstacle or a zone", "a name of its own")
    if name in links:
        yield Contradiction(f"tools.{name}", "the name of a link of the URDF", "a name of its own")
    if name == "payload":
        yield Contradiction(f"tools.{name}", "the name of the payload's box", "a name of its own")


def _tool_flaws(key: str, tool: Tool, cell: Cell, tree: UrdfTree, behind: tuple[str, ...]) -> Iterator[Contradiction]:
    stated = [each for each in STATED if getattr(tool, each) is not None]
    if tool.links is not None:
        for each in stated:
            yield Contradiction(f"{key}.{each}", "a value beside links", "links of the URDF or the tool's own values, not both")
        if not set(tool.links) <= set(behind):
            return
    elif len(stated) < len(STATED):
        missing = next(each for each in STATED if each not in stated)
        yield Contradiction(f"{key}.{missing}", "no such key", f"{', '.join(STATED)}, or links of the URDF")
        return
    parameters = _parameters(tool, cell.robot.sensor_frame, tree)
    if tool.links is not None and not parameters.mass > 0:
        yield Contradiction(f"{key}.links", "links without mass", f"links whose <inertial> the URDF states, or {', '.join(STATED)}")
    elif not (parameters.consistent if tool.links is None else _is_nearly_consistent(parameters)):
        m, mc, inertia = parameters.mass, np.round(parameters.first_moment, 9).tolist(), np.round(parameters.phi[4:], 9).tolist()
        where = f"{key}.{'inertia_kg_m2' if tool.links is None else 'links'}"
        found = f"mass {m:.6g}, first_moment {mc}, inertia {inertia}"
        yield Contradiction(where, found, "values that a rigid body can have (pseudo-inertia positive definite)")
    elif tool.box is not None and (depth := tool.box.depth(parameters.com)) < 0:
        found = f"a centre of mass at {np.round(parameters.com, 4).tolist()} m, {-depth:.3f} m outside the box"
        yield Contradiction(f"{key}.box", found, "a box that contains the tool")


def _link_flaws(cell: Cell, tree: UrdfTree, behind: tuple[str, ...]) -> Iterator[Contradiction]:
    frame = cell.robot.sensor_frame
    owner: dict[str, str] = {}
    for name, tool in cell.tools.items():
        for link in tool.links or ():
            if link not in behind:
                yield Contradiction(f"tools.{name}.links", repr(link), f"links behind the sensor frame {frame!r}, {list(behind)}")
            elif link in owner:
                found = f"{link!r}, which is in tools.{owner[link]} already"
                yield Contradiction(f"tools.{name}.links", found, "each link in one tool, once")
            owner[link] = name
    left = [link for link in behind if link not in owner and tree.has_body(link)]
    if left:
        found = f"{frame!r} with the links {left} behind it, which the sensor feels and no tool has"
        expected = f"a tool with them ([tools.NAME] with links = {left}), or a sensor frame behind them"
        yield Contradiction("robot.sensor_frame", found, expected)


def _weight_flaws(cell: Cell, tools: dict[str, InertialParameters]) -> Iterator[Contradiction]:
    """The sensor carries the tools, alone and with each payload."""
    of_tools = sum((each.phi for each in tools.values()), start=np.zeros(10))
    key = ", ".join(f"tools.{name}" for name in tools)
    alone = list(load_contradictions(key, InertialParameters(of_tools), cell))
    yield from alone
    for name, payload in {} if alone else cell.payloads.items():
        yield from load_contradictions(f"{key} and payloads.{name}", InertialParameters(of_tools + payload.parameters.phi), cell)


def _effort_flaws(cell: Cell, urdf: Urdf, tools: InertialParameters) -> Iterator[Contradiction]:
    """The drives hold arm and tools at home."""
    efforts = {joint.name: joint.effort for joint in urdf.joints}
    for name, torque in home_torques(cell, urdf, tools).items():
        effort = efforts[name]
        if effort is not None and torque > effort:
            key = ", ".join(f"tools.{each}" for each in cell.tools)
            found = f"{torque:.4g} N m on {name!r} at home, with the links"
            yield Contradiction(key, found, f"tools that the joint can hold, {effort:.4g} N m (limit effort of the URDF)")


def home_torques(cell: Cell, urdf: Urdf, carried: InertialParameters) -> dict[str, float]:
    """Size of the torque that holds each joint against gravity at home, N m, with something at the sensor frame."""
    hinges = urdf.hinges(cell.robot.base_frame, cell.robot.sensor_frame)
    tree = UrdfTree(cell.urdf, (hinge.name for hinge in hinges))
    behind = tree.behind(cell.robot.sensor_frame)
    pose = _matrix(cell.robot.base.rotation, cell.robot.base.translation) @ np.linalg.inv(tree.find_rigid_parent(cell.robot.base_frame)[1])
    axes, origins, moments = [], [], []
    for hinge, angle in zip(hinges, cell.robot.home_rad, strict=True):
        joint = tree.joints[hinge.name]
        axis = axis_of(joint)
        turn = _matrix(rotation_of(angle * axis), np.zeros(3))
        pose = pose @ tree.find_rigid_parent(end_of(joint, "parent"))[1] @ origin_of(joint) @ turn
        axes.append(pose[:3, :3] @ axis)
        origins.append(pose[:3, 3])
        moments.append(_moment(tree.rigid_body(hinge.child, without=behind), pose))
    moments[-1] = moments[-1] + _moment(carried, pose @ tree.find_rigid_parent(cell.robot.sensor_frame)[1])
    after = np.cumsum(moments[::-1], axis=0)[::-1]  # mass and first moment of all that a joint moves
    arms = after[:, 1:] - after[:, :1] * np.array(origins)
    torques = np.einsum("ij,ij->i", np.array(axes), np.cross(arms, cell.gravity))
    return {hinge.name: float(abs(torque)) for hinge, torque in zip(hinges, torques, strict=True)}


def _moment(body: InertialParameters, pose: Array) -> Array:
    """(4,), mass and first moment about the world's origin, of a body in the frame at `pose` (4, 4)."""
    return np.array([body.mass, *(pose[:3, :3] @ body.first_moment + body.mass * pose[:3, 3])])


def _matrix(rotation: Array, translation: Array) -> Array:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation, translation
    return pose
