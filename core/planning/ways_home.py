"""Ways home from the stops of a plan, for a run that may end at each of them: shorter ones than along the rest of the plan.

Each is planned, timed and confirmed like the rest. Where one is not found, not shorter or not confirmed, a run that ends there goes on
along the plan's transfers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from core.cell.cell import Box, Cell
from core.errors import NoPath, PlanDisputed, TooHeavy
from core.planning.commanded_path import PlanPart, compute_joint_paths
from core.planning.effort import path_iterations
from core.planning.joint_torques import JointTorques, refuse_too_heavy
from core.planning.plan import Leg, WayHome
from core.planning.settings import Planner
from core.planning.transfer import Transfer, plan_transfer
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.second_opinion.opinion import second_opinion

WORTH_S = 0.5
"""Robot time that a way of its own has to save."""


def add_ways_home(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    payload_box: Box,
    legs: Sequence[Leg],
    home: Transfer,
    torques: JointTorques,
    *,
    planner: Planner,
    seed: int,
) -> list[Leg]:
    """The legs, each with its own way home where there is one.

    Args:
        home: from the last leg.
        torques: that the joints have to give with the load.
    """
    found: list[Leg] = []
    rest_s = home.trajectory.duration
    period, goal = home.trajectory.period, np.array(cell.robot.home_rad)
    for leg in reversed(legs):
        way = None
        if leg is not legs[-1]:
            try:
                transfer = plan_transfer(
                    cell,
                    robot,
                    collision,
                    leg.transfer.goal,
                    goal,
                    period=period,
                    planner=planner,
                    seed=seed,
                    iterations=path_iterations(1)[0],
                    torques=torques,
                )
                if transfer.trajectory.duration < rest_s - WORTH_S:
                    way = _confirm(cell, robot, collision, payload_box, transfer, torques)
            except (NoPath, TooHeavy, PlanDisputed):
                way = None
        found.append(replace(leg, home=way))
        rest_s += leg.transfer.trajectory.duration
    return found[::-1]


def _confirm(
    cell: Cell, robot: RobotModel, collision: CollisionModel, payload_box: Box, transfer: Transfer, torques: JointTorques
) -> WayHome | None:
    """The way with the second opinion on it; None where that does not pass it."""
    period = transfer.trajectory.period
    paths = compute_joint_paths(cell, robot, collision, [PlanPart("home", transfer.trajectory)], transfer.trajectory.q[0])
    refuse_too_heavy(torques.of(paths, period))
    opinion = second_opinion(cell, payload_box, paths, period)
    return WayHome(transfer, opinion) if opinion.passes else None
