"""Which of the proposed motions can be made in a cell, and what it will tell along the way that was planned."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.cell.cell import Box, Cell
from core.errors import BadInput, Refused
from core.events import Event
from core.gap.evidence import Evidence
from core.gap.planned_path import path_of
from core.gap.proposal import CLEAR_SIGMA, Proposal, predict_along_path
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.settings import Planner
from core.recording.recording import Recording
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message


class Choice(NamedTuple):
    """A proposal with its plan; what it is predicted to do holds along that plan. No plan for what is no motion."""

    proposal: Proposal
    plan: Plan | None


def choose_experiment(
    cell: Cell, recording: Recording, evidence: Evidence, payload_box: Box, *, planner: Planner = "rrt_connect", seed: int = 0
) -> Generator[Event, None, Choice]:
    """Plans the proposals, best first, until one settles the worst tie; the best of them where none does.

    Raises:
        ValueError: the evidence leaves nothing to settle.
        BadInput: the recording is not of this cell's robot.
        Refused: none of them can be planned; the reason of the last.
    """
    if not evidence.proposals:
        raise ValueError("the evidence leaves nothing to settle: there are no proposals to choose from")
    robot = RobotModel.of_cell(cell)
    if recording.robot != robot.description:
        raise BadInput(Message.of("gap-cell", cell=cell.name), "gap-other-robot")
    collision = CollisionModel(cell, robot, payload_box)
    home = np.array(cell.robot.home_rad)
    planned: list[Choice] = []
    for proposal in evidence.proposals:
        if not proposal.motion.stops:
            return Choice(proposal, None)
        try:
            plan = yield from plan_stops(cell, robot, collision, payload_box, proposal.motion.stops, start=home, planner=planner, seed=seed)
        except Refused as reason:
            refused = reason
            continue
        told = predict_along_path(path_of(plan, robot, recording), evidence.windows, proposal.motion, proposal.ties)
        planned.append(Choice(replace(told, seconds=plan.robot_s), plan))
        if planned[-1].proposal.after >= CLEAR_SIGMA:
            break
    if not planned:
        raise refused
    return max(planned, key=lambda choice: choice.proposal.worth)
