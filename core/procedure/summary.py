"""What the report shows of the run itself, beside the recording and the identification."""

from __future__ import annotations

from dataclasses import dataclass

from core.array import Array
from core.cell.cell import Box, Cell
from core.planning.start_configuration import StartConfiguration
from core.second_opinion.opinion import Opinion


@dataclass(frozen=True)
class RunSummary:
    """A run on a robot, as the guard and the plan saw it.

    Args:
        cell: where it ran.
        payload: its name, None where unknown.
        payload_box: the box that was kept clear, sensor frame.
        starts: the start configurations in the order of the procedure.
        t: (K,), s, times of the distances below; any rate.
        distance_m: (K,), smallest distance to obstacles and protected zones, without the links that only the first joint moves.
        min_distance_m: the smallest of everything that moves, also between those times; None where the cell has neither.
        nearest: name of what was that near, None likewise.
        max_speed_m_s: of any point of robot or payload box.
        restarts: how often the guard stopped the robot and the procedure began anew.
        plan_s, robot_s, estimate_s: time of planning, motion and estimation.
        seed: of planning and simulation.
        beyond_first_m: `min_distance_m` without the links that only the first joint moves.
        opinion: the second one on the plan.
        plan_digest: SHA-256 of the plan, hexadecimal.
    """

    cell: Cell
    payload: str | None
    payload_box: Box
    starts: tuple[StartConfiguration, ...]
    t: Array
    distance_m: Array
    min_distance_m: float | None
    nearest: str | None
    max_speed_m_s: float
    restarts: int
    plan_s: float
    robot_s: float
    estimate_s: float
    seed: int
    beyond_first_m: float | None = None
    opinion: Opinion | None = None
    plan_digest: str | None = None
