"""What a run that came through leaves behind, and what of it goes into the answer and into the report."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.control.guard import SafetyRecord
from core.estimation.estimate import Identification
from core.estimation.result import Result, SafetyPart, SecondsPart, result_of
from core.planning.plan import Plan, plan_digest
from core.procedure.summary import RunSummary
from core.recording.recording import Recording
from core.requirement.answer import RequirementPart
from core.requirement.target_answer import TargetPart
from core.robot.pair_group import Nearest


@dataclass(frozen=True)
class Outcome:
    """A whole run.

    Args:
        plan: the last one, where the guard made it plan anew.
        requirement: whether the identification is good enough for the cell.
        target: how far it meets the target, and what was left out; None where the run had none.
        distances: (K, 2), time (s) and smallest distance to obstacles and zones (m).
        restarts: how often the guard stopped the robot.
        plan_s, robot_s, estimate_s: where the time went.
    """

    cell: Cell
    payload_box: Box
    plan: Plan
    recording: Recording
    identification: Identification
    requirement: RequirementPart
    target: TargetPart | None
    safety: SafetyRecord
    distances: Array
    restarts: int
    plan_s: float
    robot_s: float
    estimate_s: float
    seed: int

    def result(self, folder: Path | None = None, *, at: datetime | None = None) -> Result:
        """The answer as it leaves the engine; `at` is when the robot had done its part."""
        nearest = self._nearest
        safety = SafetyPart(
            min_distance_m=None if nearest is None else nearest.distance_m,
            nearest=None if nearest is None else nearest.second,
            max_speed_m_s=self.safety.max_speed_m_s,
            restarts=self.restarts,
            min_distance_beyond_first_joint_m=self._beyond_first_m,
        )
        seconds = SecondsPart(plan=self.plan_s, robot=self.robot_s, estimate=self.estimate_s)
        return result_of(
            self.identification,
            self.recording,
            seconds=seconds,
            requirement=self.requirement,
            target=self.target,
            safety=safety,
            folder=folder,
            plan_sha256=plan_digest(self.plan),
            at=at,
        )

    @property
    def _nearest(self) -> Nearest | None:
        """What came nearest; None in a cell without obstacles and zones."""
        nearest = self.safety.nearest
        return None if nearest is None or not np.isfinite(nearest.distance_m) else nearest

    @property
    def _beyond_first_m(self) -> float | None:
        """The smallest distance without the links that only the first joint moves."""
        least = self.safety.beyond_first_m
        return least if np.isfinite(least) else None

    @property
    def summary(self) -> RunSummary:
        """What the report shows of the run."""
        nearest = self._nearest
        return RunSummary(
            cell=self.cell,
            payload=self.recording.payload,
            payload_box=self.payload_box,
            starts=tuple(leg.start for leg in self.plan.legs),
            t=self.distances[:, 0],
            distance_m=self.distances[:, 1],
            min_distance_m=None if nearest is None else nearest.distance_m,
            nearest=None if nearest is None else nearest.second,
            max_speed_m_s=self.safety.max_speed_m_s,
            restarts=self.restarts,
            plan_s=self.plan_s,
            robot_s=self.robot_s,
            estimate_s=self.estimate_s,
            seed=self.seed,
            beyond_first_m=self._beyond_first_m,
            opinion=self.plan.opinion,
            plan_digest=plan_digest(self.plan),
        )
