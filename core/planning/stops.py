"""The stops of an experiment as what a robot goes through in a run."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass
from typing import Self

from core.errors import BadInput
from core.events import Event
from core.planning.experiment import plan_experiment
from core.planning.plan import Plan
from core.planning.sequence import PlanRequest
from core.planning.stop import Stop
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message


@dataclass(frozen=True)
class Stops:
    """A `MotionSequence` with one leg for each stop."""

    stops: tuple[Stop, ...]

    @classmethod
    def of(cls, stops: Sequence[Stop]) -> Self:
        """Stops to move for.

        Raises:
            BadInput: there are none.
        """
        if not stops:
            raise BadInput(Message.of("experiment-name"), "experiment-without-stops")
        return cls(tuple(stops))

    @property
    def steps(self) -> int:
        """How many legs there are."""
        return len(self.stops)

    def plan_legs(self, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> Generator[Event, None, Plan]:
        """A plan through the stops that are left, back to home.

        Raises:
            NoStartConfiguration, NoPath: the cell leaves no safe way.
            TooHeavy: the joints have not the torque.
            PlanDisputed: an independent check does not confirm the plan.
        """
        return plan_experiment(
            asked.cell,
            robot,
            collision,
            asked.payload_box,
            self.stops[asked.done :],
            start=asked.start,
            period=asked.period,
            planner=asked.planner,
            seed=asked.seed,
            load=asked.load,
            effort=asked.effort,
        )
