"""What a controller of Franka says of itself and its arm, held against the cell before anything moves.

From server version 8 on it gives a description of its robot, whose name is the model, with the joint limits that it keeps. Before, the
version alone tells a Panda (5) from a Research 3 (6, 7), and no limits. A serial number is in no message.
"""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import FrankaRobot
from core.cell.urdf_elements import parse
from core.errors import BadRobot, NotConnected, WrongRobot
from core.robot.model import RobotModel
from core.sessions.controller import Controller, Kinematics, check_controller, check_identity
from core.sessions.franka_line import FciLine, VersionError
from core.sessions.franka_messages import JOINTS, NEWEST, OLDEST, Command, Sample
from core.sessions.franka_path import ACCELERATION, Envelope, make_of

FIRST_S = 3.0
"""How long the first state may take."""
SUPPORTED, LEAST = f"server versions {OLDEST} to {NEWEST}", (OLDEST,)
MODELS = {5: "panda", 6: "fr3", 7: "fr3"}
"""Of servers that do not name it, by the systems that have such a server (libfranka's table of compatible versions)."""
_JOINT = re.compile(r"joint([1-7])$")


class Description(NamedTuple):
    """What a controller says of its robot.

    Args:
        model: its name. envelope: None where it does not say.
    """

    model: str
    envelope: Envelope | None


class Reached(NamedTuple):
    """A controller whose robot is the cell's."""

    line: FciLine
    sample: Sample
    description: Description


def link_of(cell: Cell) -> FrankaRobot:
    """What the cell says of the line."""
    assert isinstance(cell.session, FrankaRobot)
    return cell.session


def flange_of(sample: Sample) -> tuple[Array, Array]:
    """Position (3,), m, and rotation (3, 3) of the flange in the base: end effector and where that is in the flange are told."""
    rotation = sample.pose[:3, :3] @ sample.tool[:3, :3].T
    return sample.pose[:3, 3] - rotation @ sample.tool[:3, 3], rotation


def reach(cell: Cell, robot: RobotModel) -> Reached:
    """Connects and checks that it is the cell's robot. Nothing moves.

    Raises:
        NotConnected: nobody answers.
        WrongRobot: it is another robot, or allows less than the cell needs.
    """
    link = link_of(cell)
    try:
        line = FciLine(link.host, link.port)
    except VersionError as error:
        raise WrongRobot("session-unknown-firmware", found=str(error.version), supported=SUPPORTED) from error
    except OSError as error:
        raise NotConnected("franka-not-reached", host=link.host, port=str(link.port), reason=str(error)[:120]) from error
    try:
        sample = line.receive(FIRST_S)
        if sample is None:
            raise NotConnected("franka-silent", host=link.host, limit_s=FIRST_S)
        description = _ask_description(line, link.host)
        _check_arm(cell, robot, sample, description, line.version)
    except OSError as error:
        line.close()
        raise NotConnected("franka-not-reached", host=link.host, port=str(link.port), reason=str(error)[:120]) from error
    except BaseException:
        line.close()
        raise
    return Reached(line, sample, description)


def _ask_description(line: FciLine, host: str) -> Description:
    if not line.knows(Command.GET_MODEL):
        return Description(MODELS[line.version], None)
    _, answer = line.ask(Command.GET_MODEL)
    try:
        if answer[0] != 0:
            raise ValueError(f"status {answer[0]}")
        return read_description(answer[1:].decode("utf-8"))
    except (ValueError, BadRobot) as error:
        raise NotConnected("franka-no-description", host=host, reason=str(error)[:120]) from error


def read_description(text: str) -> Description:
    """Name and joint limits of a robot's URDF.

    Raises:
        BadRobot, ValueError: it is none of a Franka's arm.
    """
    root = parse(text, "the controller's description")
    joints = {int(found[1]): joint for joint in root.findall("joint") if (found := _JOINT.search(joint.get("name", "")))}
    if sorted(joints) != list(range(1, JOINTS + 1)):
        return Description(root.get("name", ""), None)
    limits, braking = [], []
    for _, joint in sorted(joints.items()):
        limit, near = joint.find("limit"), joint.find("position_based_velocity_limits")
        if limit is None:
            raise ValueError(f"joint {joint.get('name')} without limits")
        limits.append([float(limit.get(name, "nan")) for name in ("lower", "upper", "velocity")])
        if near is not None:
            braking.append([float(near.get(name, "nan")) for name in ("velocity_offset", "deceleration_limit")])
    lower, upper, velocity = np.array(limits).T
    offset, deceleration = np.array(braking).T if len(braking) == JOINTS else (None, None)
    if not all(np.isfinite(each).all() for each in (lower, upper, velocity, offset, deceleration) if each is not None):
        raise ValueError("limits that are no numbers")
    return Description(root.get("name", ""), Envelope(lower, upper, velocity, offset, deceleration))


def _check_arm(cell: Cell, robot: RobotModel, sample: Sample, description: Description, version: int) -> None:
    """Model, version, kinematics, limits, accelerations and load, in this order: an arm with its joints in another order has other limits,
    too."""
    position, rotation = flange_of(sample)
    envelope = description.envelope
    limits = (None, None, None) if envelope is None else (envelope.lower, envelope.upper, envelope.velocity)
    said = Controller(description.model, None, str(version), sample.q, position, rotation, *limits)
    check_identity(cell, said, supported=SUPPORTED, least=LEAST)
    if robot.n == JOINTS:
        Kinematics(cell, robot).check(sample.q, position, rotation)
    check_controller(cell, robot, said, supported=SUPPORTED, least=LEAST)
    ours, theirs = np.array(cell.robot.acceleration_rad_s2), np.array(ACCELERATION[make_of(version)])
    j = int(np.argmax(ours - theirs))
    if ours[j] > theirs[j]:
        joint = robot.description.joints[j]
        raise WrongRobot("franka-limit-acceleration", joint=joint, found=float(theirs[j]), expected=float(ours[j]))
    carried, limit = sample.end_effector_kg + float(sample.load[0]), cell.robot.payload_limit_kg
    if limit is not None and carried > limit:
        raise WrongRobot("session-payload-beyond-limit", found=carried, expected=limit)
