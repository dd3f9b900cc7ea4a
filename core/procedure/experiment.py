"""Carries an experiment out and appends what it measured to the recording that asked for it."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from pathlib import Path

import numpy as np

from core.cell.cell import Box, Cell
from core.events import Event
from core.planning.joint_torques import find_known_load
from core.planning.settings import Planner
from core.planning.stop import Stop
from core.planning.stops import Stops
from core.procedure.identify import move_and_estimate
from core.procedure.outcome import Outcome
from core.procedure.recorder import Recorder, build_estimator
from core.procedure.run import Planning, Run
from core.recording.recording import Recording, check_same_robot
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotSession
from core.twin.twin import NOMINAL, Twin


def measure_more(
    before: Recording,
    stops: Sequence[Stop],
    cell: Cell,
    session: RobotSession,
    payload_box: Box,
    *,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    effort: int = 1,
    out: Path | None = None,
    twin: Twin = NOMINAL,
) -> Generator[Event, None, Outcome]:
    """Plans an experiment, carries it out, and estimates from the old and the new samples together.

    Args:
        before: the recording that is continued; only read.
        stops: of the experiment.
        effort: how much is searched before a plan is refused.
        out: folder to make for both; nothing is written where absent.
        twin: of the cell; the estimate accounts for its effects.

    Returns:
        The outcome; its recording holds the old samples and, after a gap in time, the new ones.

    Raises:
        BadInput: nothing to move for, or the recording is not of this cell's robot as it stands.
        Refused, Stopped, Interrupted: as in `procedure.identify`.
    """
    sequence = Stops.of(stops)
    robot = RobotModel.of_cell(cell)
    check_same_robot(before, robot.description, cell.gravity_in_base)
    log = SampleLog(cell, robot, payload=before.payload, reference=None, before=before)
    recorder = Recorder(log, build_estimator(log, session.period))
    planning = Planning(sequence, planner, seed, effort, find_known_load(cell, before.payload))
    run = Run(cell, robot, session, payload_box, planning, recorder)
    plan = yield from run.make_plan(np.array(cell.robot.home_rad))
    return (yield from move_and_estimate(run, plan, twin, out))
