"""A plan carried out for its recording alone: nothing is estimated, on the way or after."""

from __future__ import annotations

from collections.abc import Generator

from core.cell.cell import Box, Cell, Payload
from core.events import Event
from core.planning.plan import Plan
from core.planning.stops import Stops
from core.procedure.recorder import Recorder
from core.procedure.run import Planning, Run
from core.recording.recording import Recording
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotSession


def record(
    cell: Cell,
    session: RobotSession,
    payload_box: Box,
    plan: Plan,
    *,
    payload: str | None = None,
    reference: Payload | None = None,
    seed: int = 0,
) -> Generator[Event, None, Recording]:
    """The recording of a plan that starts where the robot stands.

    Args:
        session: not entered yet.
        payload, reference: name of the payload, and what is known of it, for the recording.
        seed: of the plans after stops.

    Raises:
        Stopped, Refused: the guard has given up, or there is no way on after a stop.
    """
    robot = RobotModel.of_cell(cell)
    log = SampleLog(cell, robot, payload=payload, reference=reference, complete=session.complete)
    planning = Planning(Stops(tuple(leg.stop for leg in plan.legs), plan.timing), seed=seed)
    run = Run(cell, robot, session, payload_box, planning, Recorder(log))
    with session:
        yield from run.execute_plan(plan)
    return log.recording()
