"""Between which links the arm is: the base frame, the sensor frame, and what hangs behind it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.cell.urdf_elements import UrdfJoint
from core.errors import BadRobot
from core.new_cell.order import Behind, CellOrder
from core.new_cell.robot_tree import RobotTree

SENSOR_LINK = "ft_sensor"
HAND = re.compile(r"(gripper|finger|hand(?!le)|thumb|jaw|knuckle|claw)", re.IGNORECASE)
FORCE_TORQUE = re.compile(r"(^|_)(ft|fts|ft_sensor|force_torque|force_torque_sensor)(_|$)", re.IGNORECASE)

Ask = Callable[[str, tuple[str, ...]], str]
"""Asks a person a question with some answers to choose from."""


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


def choose_frames(tree: RobotTree, order: CellOrder, ask: Ask | None, notes: list[str]) -> ArmFrames:
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
            notes.append(f"Behind the sensor frame {sensor!r}, felt by the sensor as a tool: {_list(bodies)}.")
        else:
            sensor, before = _behind(tree, sensor), sensor
            notes.append(f"The sensor frame is moved from {before!r} behind what counts as robot, to {sensor!r}: {_list(bodies)}.")
    base = _base_frame(tree, sensor, order, notes)
    joints = _joints_between(tree, base, sensor)
    beside = [link for link in tree.behind(joints[-1].child) if tree.is_body(link) and link not in (sensor, *tree.behind(sensor))]
    beside = [link for link in beside if sensor not in tree.behind(link)]
    if beside:
        notes.append(f"Carried by the last joint but not by the sensor, and so part of the robot: {_list(beside)}.")
    return ArmFrames(base, sensor, joints, tool)


def _sensor_frame(tree: RobotTree, order: CellOrder, notes: list[str]) -> str:
    if order.mount is not None:
        _check_link(tree, order.mount, "--mount")
        tree.add_link(SENSOR_LINK, order.mount, np.array(order.mount_xyz), np.array(order.mount_rpy))
        notes.append(f"The sensor frame is the new link {SENSOR_LINK!r}, fixed to {order.mount!r}.")
        return SENSOR_LINK
    if order.sensor_frame is not None:
        _check_link(tree, order.sensor_frame, "--sensor-frame")
        return order.sensor_frame
    links = [link for link in tree.checked.links if not _is_of_hand(tree, link)]
    lengths = {link: sum(joint.kind in ("revolute", "continuous") for joint in tree.path(link)) for link in links}
    longest = max(lengths.values(), default=0)
    if longest == 0:
        raise BadRobot(f"{tree.where}: joints", "none that turns", "an arm of revolute joints")
    ends = [link for link in links if lengths[link] == longest]
    named = [link for link in ends if FORCE_TORQUE.search(link)]
    if named:
        notes.append(f"The sensor frame is {named[0]!r}, which has the name of a force/torque sensor; --sensor-frame LINK chooses another.")
        return named[0]
    chosen = max(ends, key=lambda link: (len(tree.path(link)), not tree.is_body(link)))
    notes.append(f"The sensor frame is {chosen!r}, the last link of the longest chain before a hand; --sensor-frame LINK chooses another.")
    return chosen


def _is_of_hand(tree: RobotTree, link: str) -> bool:
    """Whether a link is, or hangs on, what has the name of a hand or a gripper; or a joint that mimics another is above it."""
    return any(HAND.search(joint.name) or HAND.search(joint.child) or joint.mimic for joint in tree.path(link))


def _what_is_behind(sensor: str, bodies: list[str], order: CellOrder, ask: Ask | None, where: str) -> Behind:
    if order.behind is not None:
        return order.behind
    if ask is not None:
        question = (
            f"Behind the sensor frame {sensor!r} hang {_list(bodies)}. Does the sensor carry them (tool), or sit behind them (robot)?"
        )
        return Behind(ask(question, tuple(Behind)))
    raise BadRobot(
        f"{where}: links behind the sensor frame {sensor!r}",
        _list(bodies),
        "--behind-sensor tool where the sensor carries them, --behind-sensor robot where it sits behind them",
    )


def _behind(tree: RobotTree, sensor: str) -> str:
    """The farthest link behind the sensor frame, one without a body where there is one as far or at the end."""
    behind = tree.behind(sensor)
    ends = [link for link in behind if not tree.behind(link)]
    return max(ends, key=lambda link: (not tree.is_body(link), len(tree.path(link))))


def _base_frame(tree: RobotTree, sensor: str, order: CellOrder, notes: list[str]) -> str:
    if order.base_frame is not None:
        _check_link(tree, order.base_frame, "--base-frame")
        return order.base_frame
    moving = [joint for joint in tree.path(sensor) if joint.kind != "fixed"]
    if not moving:
        raise BadRobot(f"{tree.where}: link {sensor!r}", "no moving joint above it", "a sensor frame at the end of an arm")
    notes.append(f"The base frame is {moving[0].parent!r}, which carries the first moving joint; --base-frame LINK chooses another.")
    return moving[0].parent


def _joints_between(tree: RobotTree, base: str, sensor: str) -> tuple[UrdfJoint, ...]:
    path = tree.path(sensor)
    if base not in (joint.parent for joint in path):
        raise BadRobot(f"{tree.where}: base frame {base!r}", f"no chain of joints from it to {sensor!r}", "a link above the sensor frame")
    path = path[[joint.parent for joint in path].index(base) :]
    moving = tuple(joint for joint in path if joint.kind != "fixed")
    for joint in moving:
        if joint.mimic or joint.kind not in ("revolute", "continuous"):
            kind = "mimics another" if joint.mimic else f"is {joint.kind}"
            raise BadRobot(
                f"{tree.where}: joint {joint.name!r}",
                f"a joint between {base!r} and {sensor!r} that {kind}",
                f"joints that turn; --base-frame {joint.child} takes the arm behind it, --sensor-frame {joint.parent} the one before",
            )
    if not moving:
        raise BadRobot(f"{tree.where}: base frame {base!r}", f"no moving joint between it and {sensor!r}", "an arm between the two")
    return moving


def _check_link(tree: RobotTree, link: str, option: str) -> None:
    if link not in tree.checked.links:
        raise BadRobot(f"{option} {link}", f"no such link in {tree.where}", f"one of {list(tree.checked.links)}")


def _list(links: list[str]) -> str:
    return ", ".join(links)
