"""What the robot is going to be commanded along a plan, set point by set point, as plain joint positions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.control.bounds import JointLimits
from core.control.movers import Mover, Playback
from core.control.rotation import Rotation
from core.errors import PlanDisputed, Stopped
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile, JointTrajectory
from core.second_opinion.opinion import JointPath
from core.second_opinion.part_name import name_part
from core.sessions.session import RobotState


class PlanPart(NamedTuple):
    """One motion of a plan.

    Args:
        about: sensor axis, of a profile.
    """

    name: str
    along: JointTrajectory | AngularProfile
    about: str = ""


def compute_joint_paths(
    cell: Cell, robot: RobotModel, collision: CollisionModel, motions: Sequence[PlanPart], start: Array
) -> list[JointPath]:
    """The set points of motions that follow each other from joint positions `start` (n,), holds left out.

    A rotation is no trajectory but a task that the controller solves period by period: here it is solved as it will be then, by the
    same controller on a robot that follows.

    Raises:
        PlanDisputed: a rotation stands still, or a trajectory does not start where the motion before it ends.
    """
    limits = JointLimits.of(cell, robot)
    paths: list[JointPath] = []
    here = start
    for motion in motions:
        mover: Mover
        if isinstance(motion.along, AngularProfile):
            mover = Rotation(
                robot,
                collision.points,
                limits,
                cartesian_speed=cell.limits.cartesian_speed_m_s,
                profile=motion.along,
                axis="xyz".index(motion.about),
            )
        else:
            mover = Playback(motion.along)
        try:
            paths.append(JointPath(motion.name, _collect_set_points(mover, here)))
        except Stopped as error:
            raise PlanDisputed("planning-not-feasible", part=name_part(motion.name)) from error
        here = paths[-1].q[-1]
    return paths


def _collect_set_points(mover: Mover, here: Array) -> Array:
    """(N, n), the set points of one motion from standstill at q (n,), which is the first."""
    still = RobotState(t=0.0, q=here, dq=np.zeros(len(here)), q_cmd=here, wrench=np.zeros(6))
    points = [here]
    while (target := mover.next(still)) is not None:
        points.append(target)
    return np.array(points)
