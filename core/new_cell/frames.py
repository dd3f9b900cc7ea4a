"""Between which links the arm is: the base frame, the sensor frame, and what hangs behind it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.cell.urdf_elements import UrdfJoint
from core.errors import BadRobot
from core.new_cell.order import Behind, CellOrder
from core.new_cell.outline import LinkOutline, RobotOutline
from core.new_cell.robot_tree import RobotTree
from core.words.catalogue import find_language
from core.words.message import Message

SENSOR_LINK = "ft_sensor"
HAND = re.compile(r"(gripper|finger|hand(?!le)|thumb|jaw|knuckle|claw)", re.IGNORECASE)
FORCE_TORQUE = re.compile(r"(^|_)(ft|fts|ft_sensor|force_torque|force_torque_sensor)(_|$)", re.IGNORECASE)

Ask = Callable[[str, tuple[str, ...]], str]
"""Asks a person at the terminal a question, in words, with some answers to choose from."""


@dataclass(frozen=True)
class ArmFrames:
    """Where the arm begins and ends.

    Args:
        base, sensor: links.
        joints: the moving joints between them.
        tool: links behind the sensor that are a tool, those with mass or a shape.
    """

    base: str
    sensor: str
    joints: tuple[UrdfJoint, ...]
    tool: tuple[str, ...]


def choose_frames(tree: RobotTree, order: CellOrder, ask: Ask | None, notes: list[Message]) -> ArmFrames:
    """The frames as ordered, or chosen and told; adds the link `ft_sensor` where a mount was given.

    Raises:
        BadRobot: a link that is not there, no moving joint, one between the frames that is no hinge, links behind the sensor frame
            of which nobody says what they are.
    """
    sensor = _sensor_frame(tree, order, notes)
    bodies = [link for link in tree.behind(sensor) if tree.is_body(link)]
    tool: tuple[str, ...] = ()
    if bodies:
        if _what_is_behind(sensor, bodies, order, ask, tree.where) == Behind.TOOL:
            tool = tuple(bodies)
            notes.append(Message.of("newcell-felt-as-tool", sensor=sensor, links=bodies))
        else:
            sensor, before = _behind(tree, sensor), sensor
            notes.append(Message.of("newcell-sensor-moved", before=before, sensor=sensor, links=bodies))
    base = _base_frame(tree, sensor, order, notes)
    joints = _joints_between(tree, base, sensor)
    beside = [link for link in tree.behind(joints[-1].child) if tree.is_body(link) and link not in (sensor, *tree.behind(sensor))]
    beside = [link for link in beside if sensor not in tree.behind(link)]
    if beside:
        notes.append(Message.of("newcell-beside-sensor", links=beside))
    return ArmFrames(base, sensor, joints, tool)


def _propose_frames(tree: RobotTree) -> tuple[str, str]:
    """Base and sensor frame as they are chosen where nobody says anything.

    Raises:
        BadRobot: nothing in the description can be an arm.
    """
    nothing_said, notes = CellOrder(name="any", urdf=Path(tree.where)), list[Message]()
    sensor = _sensor_frame(tree, nothing_said, notes)
    return _base_frame(tree, sensor, nothing_said, notes), sensor


def outline_robot(tree: RobotTree) -> RobotOutline:
    """What there is to choose from.

    Raises:
        BadRobot: nothing in the description can be an arm.
    """
    base, sensor = _propose_frames(tree)
    roots = [link for link in tree.checked.links if link not in tree.parents]
    names = [name for root in roots for name in (root, *tree.behind(root))]
    return RobotOutline(
        robot=tree.root.get("name", "")[:150],
        links=[_outline_link(tree, name) for name in names],
        base_frame=base,
        sensor_frame=sensor,
    )


def _outline_link(tree: RobotTree, name: str) -> LinkOutline:
    above = tree.parents.get(name)
    return LinkOutline(
        name=name,
        parent=None if above is None else above.parent,
        joint=None if above is None else above.name,
        kind=None if above is None else above.kind,
        is_body=tree.is_body(name),
    )


def _sensor_frame(tree: RobotTree, order: CellOrder, notes: list[Message]) -> str:
    if order.mount is not None:
        _check_link(tree, order.mount, "--mount")
        tree.add_link(SENSOR_LINK, order.mount, np.array(order.mount_xyz), np.array(order.mount_rpy))
        notes.append(Message.of("newcell-sensor-mounted", link=SENSOR_LINK, mount=order.mount))
        return SENSOR_LINK
    if order.sensor_frame is not None:
        _check_link(tree, order.sensor_frame, "--sensor-frame")
        return order.sensor_frame
    links = [link for link in tree.checked.links if not _is_of_hand(tree, link)]
    lengths = {link: sum(joint.kind in ("revolute", "continuous") for joint in tree.path(link)) for link in links}
    longest = max(lengths.values(), default=0)
    if longest == 0:
        raise BadRobot(tree.where, "newcell-no-turning-joint")
    ends = [link for link in links if lengths[link] == longest]
    named = [link for link in ends if FORCE_TORQUE.search(link)]
    if named:
        notes.append(Message.of("newcell-sensor-named", link=named[0]))
        return named[0]
    chosen = max(ends, key=lambda link: (len(tree.path(link)), not tree.is_body(link)))
    notes.append(Message.of("newcell-sensor-last", link=chosen))
    return chosen


def _is_of_hand(tree: RobotTree, link: str) -> bool:
    """Whether a link is, or hangs on, what has the name of a hand or a gripper; or a joint that mimics another is above it."""
    return any(HAND.search(joint.name) or HAND.search(joint.child) or joint.mimic for joint in tree.path(link))


def _what_is_behind(sensor: str, bodies: list[str], order: CellOrder, ask: Ask | None, where: str) -> Behind:
    if order.behind is not None:
        return order.behind
    if ask is not None:
        question = Message.of("newcell-what-is-behind", sensor=sensor, links=bodies)
        return Behind(ask(question.say(find_language()), tuple(Behind)))
    raise BadRobot(Message.of("newcell-behind-sensor", file=where, sensor=sensor), "newcell-links-of-none", links=bodies)


def _behind(tree: RobotTree, sensor: str) -> str:
    """The farthest link behind the sensor frame, one without a body where there is one as far or at the end."""
    behind = tree.behind(sensor)
    ends = [link for link in behind if not tree.behind(link)]
    return max(ends, key=lambda link: (not tree.is_body(link), len(tree.path(link))))


def _base_frame(tree: RobotTree, sensor: str, order: CellOrder, notes: list[Message]) -> str:
    if order.base_frame is not None:
        _check_link(tree, order.base_frame, "--base-frame")
        return order.base_frame
    moving = [joint for joint in tree.path(sensor) if joint.kind != "fixed"]
    if not moving:
        raise BadRobot(f"{tree.where}: link {sensor!r}", "newcell-sensor-on-no-arm")
    notes.append(Message.of("newcell-base-chosen", link=moving[0].parent))
    return moving[0].parent


def _joints_between(tree: RobotTree, base: str, sensor: str) -> tuple[UrdfJoint, ...]:
    path = tree.path(sensor)
    where = Message.of("newcell-base-frame", file=tree.where, base=base)
    if base not in (joint.parent for joint in path):
        raise BadRobot(where, "newcell-base-apart", sensor=sensor)
    path = path[[joint.parent for joint in path].index(base) :]
    moving = tuple(joint for joint in path if joint.kind != "fixed")
    for joint in moving:
        if joint.mimic or joint.kind not in ("revolute", "continuous"):
            raise BadRobot(
                f"{tree.where}: joint {joint.name!r}", "newcell-joint-of-no-arm",
                base=base, sensor=sensor, type=joint.kind, mimics=joint.mimic, child=joint.child, parent=joint.parent,
            )  # fmt: skip
    if not moving:
        raise BadRobot(where, "newcell-base-unmoved", sensor=sensor)
    return moving


def _check_link(tree: RobotTree, link: str, option: str) -> None:
    if link not in tree.checked.links:
        raise BadRobot(f"{option} {link}", "newcell-no-such-link", file=tree.where, links=tree.checked.links)
