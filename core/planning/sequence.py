"""What a robot goes through in a run, planned from wherever it stands: the poses of the procedure, or something else from leg to leg."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import Protocol

from core.array import Array
from core.cell.cell import Box, Cell
from core.errors import Refused
from core.events import Event
from core.planning.fewer_axes import axes_with_room
from core.planning.joint_torques import Load
from core.planning.plan import Plan
from core.planning.search import plan_procedure
from core.planning.settings import WHOLE, Planner, Scope, Timing
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel


@dataclass(frozen=True)
class PlanRequest:
    """What is to be planned: the legs that are left after `done`, from joint positions `start` (n,), with set points every `period` s.

    Args:
        load: what the joints' torques are judged with; guessed where None.
    """

    cell: Cell
    payload_box: Box
    start: Array
    done: int
    period: float
    planner: Planner
    seed: int
    load: Load | None = None
    effort: int = 1


class MotionSequence(Protocol):
    """Legs, one after the other; plain data, which another process can plan."""

    @property
    def steps(self) -> int:
        """How many legs there are."""

    def plan_legs(self, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> Generator[Event, None, Plan]:
        """A plan through the legs that are left, back to home.

        Args:
            robot, collision: of the cell with the payload box.

        Raises:
            NoStartConfiguration, NoPath: the cell leaves no safe way.
            TooHeavy: the joints have not the torque.
            PlanDisputed: an independent check does not confirm the plan.
        """


@dataclass(frozen=True)
class Procedure:
    """The poses of the procedure (Fig. 2), all or a part of them.

    Args:
        mass_guess_kg: what repetitions are planned for.
    """

    timing: Timing
    mass_guess_kg: float = 1.0
    scope: Scope = WHOLE

    @property
    def steps(self) -> int:
        """How many legs there are: one for each pose."""
        return len(self.scope.poses)

    def plan_legs(self, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> Generator[Event, None, Plan]:
        """A plan through the poses that are left, back to home.

        Raises:
            Refused: no safe way, not enough torque, or a disputed plan. Where the whole procedure fails because an axis has no room, the
                refusal says which axes can be planned.
        """
        try:
            return (yield from self._part(self.scope, asked, robot, collision))
        except Refused as refusal:
            if not asked.done:
                axes = axes_with_room(self.scope, refusal, lambda part: self._part(part, asked, robot, collision))
                if axes:
                    refusal.offer_axes(axes)
            raise

    def _part(self, scope: Scope, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> Generator[Event, None, Plan]:
        return plan_procedure(
            asked.cell,
            robot,
            collision,
            asked.payload_box,
            start=asked.start,
            poses=scope.poses[asked.done :],
            rotations=scope.rotations,
            period=asked.period,
            timing=self.timing,
            mass_guess_kg=self.mass_guess_kg,
            planner=asked.planner,
            seed=asked.seed,
            load=asked.load,
            effort=asked.effort,
        )
