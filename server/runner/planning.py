"""Planning in a process of its own: OMPL with a Python checker would wake the control loop 5 to 25 ms late."""

from __future__ import annotations

import signal
from collections.abc import Generator
from dataclasses import dataclass
from multiprocessing.connection import Connection

import numpy as np
from numpy.typing import NDArray

from core.cell import Box, Cell
from core.collision import CollisionModel
from core.errors import HeftError, NoStartConfiguration, Refused
from core.events import Event
from core.plan import POSES, Plan, plan_procedure
from core.plan_settings import Planner, Timing
from core.robot import RobotModel
from server.runner.context import CONTEXT
from server.runner.messages import Failed

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PlanRequest:
    """What is to be planned: the poses that are left after `done`, from joint positions `start` (n,)."""

    cell: Cell
    payload_box: Box
    start: Array
    done: int
    period: float
    timing: Timing
    mass_guess_kg: float
    planner: Planner
    seed: int


class PlanRefused(Refused):
    """Planning refused in the other process.

    Args:
        failed: what it said.
    """

    def __init__(self, failed: Failed) -> None:
        super().__init__(failed.message)
        self.failed = failed


class PlanningProcess:
    """A process that plans what it is asked, one thing after the other; it ends with this object or with its maker."""

    def __init__(self) -> None:
        self._connection, theirs = CONTEXT.Pipe()
        self._process = CONTEXT.Process(target=_serve, args=(theirs,), name="heft-planning", daemon=True)
        self._process.start()
        theirs.close()

    def ask(self, request: PlanRequest) -> Generator[Event | None, None, Plan]:
        """Events of the planning as they come, None every 50 ms while there is none; returns the plan.

        Raises:
            PlanRefused: there is no safe way, or the planning process died.
        """
        self._connection.send(request)
        while True:
            if not self._connection.poll(0.05):
                yield None
                continue
            try:
                answer = self._connection.recv()
            except EOFError:
                raise PlanRefused(Failed("PlannerLost", "the planning process ended unexpectedly; start a new run.")) from None
            if isinstance(answer, Failed):
                raise PlanRefused(answer)
            if isinstance(answer, Plan):
                return answer
            yield answer

    def close(self) -> None:
        """Ends the process, whatever it plans."""
        self._process.kill()
        self._process.join()
        self._connection.close()


def _serve(connection: Connection) -> None:
    """The planning process: until the other end is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, which ends us in order
    while True:
        try:
            request: PlanRequest = connection.recv()
            for answer in _answers(request):
                connection.send(answer)
        except (EOFError, BrokenPipeError):
            return


def _answers(request: PlanRequest) -> Generator[Event | Plan | Failed, None, None]:
    """Events, then the plan or why there is none."""
    try:
        robot = RobotModel.of_cell(request.cell)
        collision = CollisionModel(request.cell, robot, request.payload_box)
        yield (
            yield from plan_procedure(
                request.cell,
                robot,
                collision,
                request.payload_box,
                start=request.start,
                poses=POSES[request.done :],
                period=request.period,
                timing=request.timing,
                mass_guess_kg=request.mass_guess_kg,
                planner=request.planner,
                seed=request.seed,
            )
        )
    except HeftError as error:
        in_the_way = error.in_the_way if isinstance(error, NoStartConfiguration) else None
        yield Failed(type(error).__name__, str(error), in_the_way)
