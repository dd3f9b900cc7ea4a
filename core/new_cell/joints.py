"""Joints as the procedure needs them: those of the arm with all limits, all others fixed."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np

from core.cell.urdf_elements import UrdfJoint
from core.errors import BadInput
from core.new_cell.frames import ArmFrames
from core.new_cell.robot_tree import RobotTree
from core.new_cell.values import JointValues
from core.words.message import Message

TURN = 2 * np.pi
DEFAULT_VELOCITY = 1.0  # rad/s
ACCELERATION_PER_VELOCITY = 5.0  # 1/s: the joint's greatest speed is reached in 0.2 s
ACCELERATIONS = (1.0, 10.0)  # rad/s2, least and greatest that is proposed


def fix_others(tree: RobotTree, frames: ArmFrames, notes: list[Message]) -> None:
    """Fixes every joint that is not the arm's: where it stands at 0, or at the limit nearest to it; a mimic joint where it follows."""
    own = {joint.name for joint in frames.joints}
    others = {joint.name: joint for joint in tree.checked.joints if joint.kind != "fixed" and joint.name not in own}
    values = {name: _value(joint) for name, joint in others.items() if not joint.mimic}
    for name, joint in others.items():
        if joint.mimic:
            values[name] = _follow(tree.joint(name), values)
    for name, joint in others.items():
        tree.fix(joint, values[name])
        if joint.kind == "prismatic":
            notes.append(Message.of("newcell-slide-fixed", joint=name, type=joint.kind, mimics=joint.mimic, place_m=values[name]))
        else:
            notes.append(Message.of("newcell-joint-fixed", joint=name, type=joint.kind, mimics=joint.mimic, angle_rad=values[name]))


def _value(joint: UrdfJoint) -> float:
    if joint.kind in ("floating", "planar", "continuous") or joint.lower is None or joint.upper is None or joint.lower > joint.upper:
        return 0.0
    return float(np.clip(0.0, joint.lower, joint.upper))


def _follow(element: ET.Element, values: dict[str, float]) -> float:
    """Where a mimic joint stands when the other stands at its value; beyond the first one, at 0."""
    mimic = element.find("mimic")
    if mimic is None:
        return 0.0
    try:
        multiplier, offset = float(mimic.get("multiplier", "1")), float(mimic.get("offset", "0"))
    except ValueError:
        return 0.0
    value = multiplier * values.get(mimic.get("joint", ""), 0.0) + offset
    return value if abs(value) < 1e4 else 0.0


GIVEN = {"lower_rad": "lower", "upper_rad": "upper", "velocity_rad_s": "velocity", "effort_n_m": "effort"}
"""Of what is given for a joint, what the URDF calls it."""


def put_limits(tree: RobotTree, frames: ArmFrames, given: dict[str, JointValues]) -> ArmFrames:
    """Gives joints of the arm the limits that somebody has stated; the frames with the joints as they are then.

    Raises:
        BadInput: a joint that the arm does not have, or a range that is none.
    """
    names = [joint.name for joint in frames.joints]
    for name, values in given.items():
        if name not in names:
            raise BadInput(f"joints.{name}", "newcell-joint-unknown", joints=names)
        if values.lower_rad is not None and values.upper_rad is not None and values.lower_rad >= values.upper_rad:
            raise BadInput(f"joints.{name}.lower_rad", "newcell-range-empty", lower_rad=values.lower_rad, upper_rad=values.upper_rad)
        if values.lower_rad is not None and values.upper_rad is not None:
            tree.joint(name).set("type", "revolute")  # also one that the description lets turn without end
        for key, limit in GIVEN.items():
            value = getattr(values, key)
            if value is not None:
                tree.set_limit(name, limit, value)
    joints = {joint.name: joint for joint in tree.checked.joints}
    return replace(frames, joints=tuple(joints[name] for name in names))


def complete_limits(tree: RobotTree, frames: ArmFrames, notes: list[Message]) -> tuple[str, ...]:
    """Gives every joint of the arm all its limits and tells which; returns the joints whose effort is still to be estimated."""
    without_effort = []
    for joint in frames.joints:
        name = joint.name
        if joint.kind == "continuous":
            given = joint.lower is not None and joint.upper is not None and -TURN <= joint.lower < joint.upper <= TURN
            lower, upper = (joint.lower or 0.0, joint.upper or 0.0) if given else (-TURN, TURN)
            tree.joint(name).set("type", "revolute")
            notes.append(Message.of("newcell-endless-limited", joint=name, lower_rad=lower, upper_rad=upper))
            tree.set_limit(name, "lower", lower)
            tree.set_limit(name, "upper", upper)
        elif joint.lower is None or joint.upper is None:
            lower = -np.pi if joint.lower is None else joint.lower
            upper = np.pi if joint.upper is None else joint.upper
            notes.append(Message.of("newcell-range-taken", joint=name, lower_rad=lower, upper_rad=upper))
            tree.set_limit(name, "lower", lower)
            tree.set_limit(name, "upper", upper)
        if not joint.velocity:
            notes.append(Message.of("newcell-velocity-taken", joint=name, velocity_rad_s=DEFAULT_VELOCITY))
            tree.set_limit(name, "velocity", DEFAULT_VELOCITY)
        if not joint.effort:
            tree.set_limit(name, "effort", 1.0)
            without_effort.append(name)
    return tuple(without_effort)


def propose_accelerations(velocities: list[float]) -> list[float]:
    """URDFs have no limit of acceleration: the greatest speed in 0.2 s, between 1 and 10 rad/s2."""
    return [round(float(np.clip(ACCELERATION_PER_VELOCITY * velocity, *ACCELERATIONS)), 2) for velocity in velocities]


def choose_accelerations(frames: ArmFrames, velocities: list[float], given: dict[str, JointValues], notes: list[Message]) -> list[float]:
    """The greatest acceleration of each joint: as it was stated, else proposed and told."""
    stated = [None if joint.name not in given else given[joint.name].acceleration_rad_s2 for joint in frames.joints]
    proposed = propose_accelerations(velocities)
    if None in stated:
        least, most = ACCELERATIONS
        taken = [value for value, known in zip(proposed, stated, strict=True) if known is None]
        told = {"seconds_s": 1.0 / ACCELERATION_PER_VELOCITY, "least_rad_s2": least, "most_rad_s2": most}
        notes.append(Message.of("newcell-accelerations-taken", accelerations_rad_s2=taken, **told))
    return [value if known is None else known for value, known in zip(proposed, stated, strict=True)]
