"""Planning in a process of its own: OMPL with a Python checker would wake the control loop 5 to 25 ms late."""

from __future__ import annotations

import signal
from collections.abc import Callable, Generator
from multiprocessing import get_context
from multiprocessing.connection import Connection

from core.errors import HeftError, Refused
from core.events import Event
from core.planning.plan import Plan
from core.planning.stops import PlanRequest, Stops
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message
from server.runner.messages import Failed
from server.runner.priority import Priority, take

FORK = get_context("fork")


class PlanRefused(Refused):
    """Planning refused in the other process.

    Args:
        failed: what it said.
    """

    def __init__(self, failed: Failed) -> None:
        super().__init__(failed.message.code, **failed.message.parameters)
        self.failed = failed


class PlanningProcess:
    """A process that plans what it is asked, one thing after the other; it ends with this object or with its maker.

    It is a plain fork, for its maker has the engine and no threads yet: a fork server of the maker's own would import everything anew.

    Args:
        stops: what the robot goes through.
        unshared: ends of pipes that the process is not to keep open.
    """

    def __init__(self, stops: Stops, *unshared: Connection) -> None:
        self.stops = stops
        self._connection, theirs = FORK.Pipe()
        arguments = (stops, theirs, self._connection, *unshared)
        self._process = FORK.Process(target=_serve, args=arguments, name="heft-planning", daemon=True)
        self._process.start()
        theirs.close()

    def ask(self, request: PlanRequest, look: Callable[[], None]) -> Generator[Event, None, Plan]:
        """Events of the planning as they come; returns the plan.

        Args:
            look: is called before each event, and every 50 ms while there is none; what it raises ends the waiting.

        Raises:
            PlanRefused: there is no safe way, or the planning process died.
        """
        self._connection.send(request)
        while True:
            if not self._connection.poll(0.05):
                look()
                continue
            try:
                answer = self._connection.recv()
            except EOFError:
                raise PlanRefused(Failed("PlannerLost", Message.of("runs-planner-lost"))) from None
            if isinstance(answer, Failed):
                raise PlanRefused(answer)
            if isinstance(answer, Plan):
                return answer
            look()
            yield answer

    def close(self) -> None:
        """Ends the process, whatever it plans."""
        self._process.kill()
        self._process.join()
        self._connection.close()


def _serve(stops: Stops, connection: Connection, *unshared: Connection) -> None:
    """The planning process: until the other end is gone."""
    for end in unshared:
        end.close()  # who waits for its maker's end would wait for ours too
    take(Priority.PLANNING)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, which ends us in order
    while True:
        try:
            request: PlanRequest = connection.recv()
            for answer in _answers(stops, request):
                connection.send(answer)
        except (EOFError, BrokenPipeError):
            return


def _answers(stops: Stops, request: PlanRequest) -> Generator[Event | Plan | Failed, None, None]:
    """Events, then the plan or why there is none."""
    try:
        robot = RobotModel.of_cell(request.cell)
        collision = CollisionModel(request.cell, robot, request.payload_box)
        yield (yield from stops.plan(request, robot, collision))
    except HeftError as error:
        yield Failed(type(error).__name__, error.message, error.in_the_way)
