"""What a robot goes through in a run: stops, one after the other, planned from wherever it stands.

The procedure of the paper is one such list, an experiment another.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field, replace
from typing import Self

from core.array import Array
from core.cell.cell import Box, Cell
from core.errors import BadInput, Refused
from core.events import Event, drive
from core.planning.joint_torques import Load
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.settings import WHOLE, Planner, Scope, Timing
from core.planning.stop import AXES, Axis, Direction, Stop, Swings, Wave
from core.requirement.target import Target
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message

WAVE_S = 15.0
LOWEST_HZ, HIGHEST_HZ = 0.1, 3.0
"""Of a wave for the joints' torques: below, friction is never the same twice; above, motors and gears are no longer rigid."""


@dataclass(frozen=True)
class PlanRequest:
    """What is to be planned: the stops that are left after `done`, from joint positions `start` (n,), with set points every `period` s.

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


@dataclass(frozen=True)
class Stops:
    """Stops in their order; plain data, which another process can plan.

    Args:
        timing: holds, accuracy and robot time.
        mass_guess_kg: what repetitions are planned for.
        target: of a run that ends where it is reached: a way home is wanted from every stop, and as much knowledge a second as may be.

    Raises:
        BadInput: there are none.
    """

    stops: tuple[Stop, ...]
    timing: Timing = field(default_factory=Timing)
    mass_guess_kg: float = 1.0
    target: Target | None = None

    def __post_init__(self) -> None:
        if not self.stops:
            raise BadInput(Message.of("experiment-name"), "experiment-without-stops")

    @classmethod
    def of_procedure(
        cls, scope: Scope = WHOLE, timing: Timing | None = None, mass_guess_kg: float = 1.0, *, target: Target | None = None
    ) -> Self:
        """The poses of the procedure (Fig. 2), all or a part: each sensor axis against gravity, then along it, where it is turned about.

        Against gravity first: the rotation then starts where the hold along gravity has just been measured.
        """
        timing = timing or Timing()
        stops: list[Stop] = []
        for axis in AXES:
            if axis in scope.axes:
                rotation = Swings(about=axis, excursion_rad=timing.swing_rad, repetitions=None) if scope.rotations else None
                stops += [Stop(down=_along(axis, -1.0)), Stop(down=_along(axis, 1.0), swings=rotation)]
        return cls(tuple(stops), timing, mass_guess_kg, target)

    @classmethod
    def of_joint_torques(cls, axes: str = "xyz") -> Self:
        """A wave of all joints at each of the sensor's axes along gravity, as tells most of the payload through the joints' torques."""
        wave = Wave(seconds=WAVE_S, lowest_hz=LOWEST_HZ, highest_hz=HIGHEST_HZ, wrist=None)
        return cls(tuple(Stop(down=_along(axis, 1.0), wave=wave) for axis in AXES if axis in axes))

    def __len__(self) -> int:
        return len(self.stops)

    @property
    def labels(self) -> tuple[str, ...]:
        """What points down at each: `x+`, or `free`."""
        return tuple(stop.label for stop in self.stops)

    def plan(self, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> Generator[Event, None, Plan]:
        """A plan through the stops that are left, back to home.

        Args:
            robot, collision: of the cell with the payload box.

        Raises:
            NoStartConfiguration, NoPath: the cell leaves no safe way. Where a sensor axis of the procedure has no room, the refusal says
                which axes can be planned.
            TooHeavy: the joints have not the torque.
            PlanDisputed: an independent check does not confirm the plan.
        """
        try:
            return (yield from self._plan(asked, robot, collision))
        except Refused as refusal:
            if not asked.done:
                axes = self._axes_with_room(refusal, asked, robot, collision)
                if axes:
                    refusal.offer_axes(axes)
            raise

    def _plan(self, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> Generator[Event, None, Plan]:
        return plan_stops(
            asked.cell,
            robot,
            collision,
            asked.payload_box,
            self.stops[asked.done :],
            start=asked.start,
            timing=self.timing,
            mass_guess_kg=self.mass_guess_kg,
            period=asked.period,
            planner=asked.planner,
            seed=asked.seed,
            load=asked.load,
            effort=asked.effort,
            target=self.target,
        )

    def _axes_with_room(self, refusal: Refused, asked: PlanRequest, robot: RobotModel, collision: CollisionModel) -> str:
        """The sensor axes that can be planned without those that are refused.

        Empty where there is no plan for any, where no axis is held both ways, or where the refusal is for something else than an axis.
        """
        left, refused = self, refusal.axis
        while refused:
            stops = tuple(stop for stop in left.stops if stop.label[0] != refused[0])
            if not _axes_of(stops):
                break
            left = replace(left, stops=stops)
            try:
                drive(left._plan(asked, robot, collision))
            except Refused as further:
                refused = further.axis
            else:
                return _axes_of(stops)
        return ""


def _along(axis: Axis, sign: float) -> Direction:
    x, y, z = (sign if each == axis else 0.0 for each in AXES)
    return x, y, z


def _axes_of(stops: tuple[Stop, ...]) -> str:
    """The sensor axes that are held both against and along gravity."""
    labels = {stop.label for stop in stops}
    return "".join(axis for axis in AXES if {f"{axis}+", f"{axis}-"} <= labels)


PROCEDURE = Stops.of_procedure()
"""The whole of it."""
