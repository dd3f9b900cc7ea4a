"""Whether a robot may stand where a plan begins, and what torques and the second opinion say of a finished plan."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.planning.commanded_path import compute_joint_paths
from core.planning.joint_torques import JointTorques, Load, refuse_too_heavy
from core.planning.path import START, check_end
from core.planning.plan import Leg, motions_of
from core.planning.summary import PlanTorques
from core.planning.throw import ThrowCheck
from core.planning.transfer import Transfer
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.second_opinion.opinion import JointPath, Opinion, second_opinion
from core.second_opinion.refusal import refuse_disputed


def check_standing(cell: Cell, robot: RobotModel, collision: CollisionModel, start: Array, load: Load, period: float) -> JointTorques:
    """The torques of the joints with a load, for a robot that may be at joint positions `start` (n,) and holds it there and at home.

    Raises:
        NoPath: it may not be there.
        TooHeavy: it cannot.
    """
    check_end(START, start, robot, collision, ThrowCheck(cell))
    torques = JointTorques(cell, robot, load)
    home = np.array(cell.robot.home_rad)
    refuse_too_heavy(torques.of([JointPath("start", start[None]), JointPath("home", home[None])], period))
    return torques


class Confirmation(NamedTuple):
    """What was found of a finished plan, set point by set point."""

    opinion: Opinion
    torques: PlanTorques
    commanded: tuple[JointPath, ...]


def confirm_plan(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    payload_box: Box,
    legs: Sequence[Leg],
    home: Transfer,
    torques: JointTorques,
) -> Confirmation:
    """Torques and the second opinion on legs and the way home, every set point as it will be commanded.

    Raises:
        TooHeavy: a joint has not the torque.
        PlanDisputed: the second opinion does not confirm them, or one of their motions cannot be carried out.
    """
    first = legs[0].transfer if legs else home
    paths = compute_joint_paths(cell, robot, collision, motions_of(legs, home), first.trajectory.q[0])
    asked = torques.of(paths, home.trajectory.period)
    refuse_too_heavy(asked)
    opinion = second_opinion(cell, payload_box, paths, home.trajectory.period)
    refuse_disputed(cell, opinion)
    return Confirmation(opinion, asked, tuple(paths))
