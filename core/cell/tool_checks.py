"""What is wrong with a cell's tools: by themselves, beside the links of the URDF, or as a weight on sensor and drives."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from core.array import Array
from core.cell.contradictions import load_contradictions
from core.cell.tool import STATED
from core.cell.urdf import Urdf
from core.cell.urdf_tree import UrdfTree, axis_of, end_of, origin_of
from core.errors import BadCell
from core.payload.inertia import InertialParameters, pseudo_inertia
from core.payload.rotations import rotation_of

if TYPE_CHECKING:
    from core.cell.cell import Cell, Tool


HARDLY_NEGATIVE = 1e-6
"""Of the largest eigenvalue: values are written with six digits."""


def tool_flaws(cell: Cell, urdf: Urdf) -> Iterator[BadCell]:
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


def _name_flaws(cell: Cell, name: str, links: tuple[str, ...]) -> Iterator[BadCell]:
    """Bodies are told apart by their names."""
    where = cell.locate(f"tools.{name}")
    if name in {obstacle.name for obstacle in cell.obstacles} | {zone.name for zone in cell.zones}:
        yield BadCell(where, "tools-named-like-obstacle")
    if name in links:
        yield BadCell(where, "tools-named-like-link")
    if name == "payload":
        yield BadCell(where, "tools-named-like-payload")


def _tool_flaws(key: str, tool: Tool, cell: Cell, tree: UrdfTree, behind: tuple[str, ...]) -> Iterator[BadCell]:
    stated = [each for each in STATED if getattr(tool, each) is not None]
    if tool.links is not None:
        for each in stated:
            yield BadCell(cell.locate(f"{key}.{each}"), "tools-value-beside-links")
        if not set(tool.links) <= set(behind):
            return
    elif len(stated) < len(STATED):
        missing = next(each for each in STATED if each not in stated)
        yield BadCell(cell.locate(f"{key}.{missing}"), "tools-without-value", keys=STATED)
        return
    parameters = _parameters(tool, cell.robot.sensor_frame, tree)
    if tool.links is not None and not parameters.mass > 0:
        yield BadCell(cell.locate(f"{key}.links"), "tools-links-massless", keys=STATED)
    elif not (parameters.consistent if tool.links is None else _is_nearly_consistent(parameters)):
        mc, inertia = np.round(parameters.first_moment, 9).tolist(), np.round(parameters.phi[4:], 9).tolist()
        where = cell.locate(f"{key}.{'inertia_kg_m2' if tool.links is None else 'links'}")
        yield BadCell(where, "tools-inertia", mass_kg=parameters.mass, first_moment_kg_m=mc, inertia_kg_m2=inertia)
    elif tool.box is not None and (depth := tool.box.depth(parameters.com)) < 0:
        com = np.round(parameters.com, 4).tolist()
        yield BadCell(cell.locate(f"{key}.box"), "tools-outside-box", com_m=com, distance_m=-depth)


def _link_flaws(cell: Cell, tree: UrdfTree, behind: tuple[str, ...]) -> Iterator[BadCell]:
    frame = cell.robot.sensor_frame
    owner: dict[str, str] = {}
    for name, tool in cell.tools.items():
        where = cell.locate(f"tools.{name}.links")
        for link in tool.links or ():
            if link not in behind:
                yield BadCell(where, "tools-link-not-behind-sensor", link=link, frame=frame, links=behind, count=len(behind))
            elif link in owner:
                yield BadCell(where, "tools-link-twice", link=link, tool=owner[link])
            owner[link] = name
    left = [link for link in behind if link not in owner and tree.has_body(link)]
    if left:
        yield BadCell(cell.locate("robot.sensor_frame"), "tools-links-of-none", frame=frame, links=left)


def _weight_flaws(cell: Cell, tools: dict[str, InertialParameters]) -> Iterator[BadCell]:
    """The sensor carries the tools, alone and with each payload."""
    of_tools = sum((each.phi for each in tools.values()), start=np.zeros(10))
    keys = [f"tools.{name}" for name in tools]
    alone = list(load_contradictions(keys, InertialParameters(of_tools), cell))
    yield from alone
    for name, payload in {} if alone else cell.payloads.items():
        yield from load_contradictions([*keys, f"payloads.{name}"], InertialParameters(of_tools + payload.parameters.phi), cell)


def _effort_flaws(cell: Cell, urdf: Urdf, tools: InertialParameters) -> Iterator[BadCell]:
    """The drives hold arm and tools at home."""
    efforts = {joint.name: joint.effort for joint in urdf.joints}
    for name, torque in home_torques(cell, urdf, tools).items():
        effort = efforts[name]
        if effort is not None and torque > effort:
            where = cell.locate(", ".join(f"tools.{each}" for each in cell.tools))
            yield BadCell(where, "tools-too-heavy-for-joint", torque_n_m=torque, joint=name, effort_n_m=effort)


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
