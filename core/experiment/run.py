"""Carries an experiment out and appends what it measured to the recording that asked for it."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.cell import Box, Cell
from core.errors import BadInput
from core.events import Event
from core.experiment.plan import plan_experiment
from core.gap.experiment import Stop
from core.outcome import Outcome
from core.plan import Plan
from core.plan_settings import Planner, Timing
from core.procedure import Run, carried_out
from core.recording import Recording, appended
from core.sample_log import SampleLog
from core.sessions.session import RobotSession
from core.twin import NOMINAL, Twin

Array = NDArray[np.float64]


def measure_more(
    before: Recording,
    stops: Sequence[Stop],
    cell: Cell,
    session: RobotSession,
    payload_box: Box,
    *,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    out: Path | None = None,
    twin: Twin = NOMINAL,
) -> Generator[Event, None, Outcome]:
    """Plans an experiment, carries it out, and estimates from the old and the new samples together.

    Args:
        before: the recording that is continued; only read.
        stops: of the experiment.
        out: folder to make for both; nothing is written where absent.
        twin: of the cell; the estimate accounts for its effects.

    Returns:
        The outcome; its recording holds the old samples and, after a gap in time, the new ones.

    Raises:
        BadInput: nothing to move for, or the recording is not of this cell's robot.
        Refused, Stopped, Interrupted: as in `procedure.identify`.
    """
    run = _Experiment(before, stops, cell, session, payload_box, planner, seed)
    run.twin = twin
    plan = yield from run.planned(np.array(cell.robot.home_rad))
    return (yield from carried_out(run, plan, before.payload, None, out))


class _Experiment(Run):
    """One robot that goes through the stops of an experiment."""

    def __init__(
        self,
        before: Recording,
        stops: Sequence[Stop],
        cell: Cell,
        session: RobotSession,
        payload_box: Box,
        planner: Planner,
        seed: int,
    ) -> None:
        super().__init__(cell, session, payload_box, Timing(), 1.0, planner, seed)
        if not stops:
            raise BadInput("the experiment", "no stops", "a motion; a second payload is put on by hand and run with `heft run`")
        if before.robot != self.robot.description:
            raise BadInput("the recording", "another robot than the cell's", f"a recording of {cell.name}")
        self.before, self.stops = before, stops
        self.steps = len(stops)

    def planned(self, start: Array, done: int = 0) -> Generator[Event, None, Plan]:
        """See `Run.planned`."""
        plan = yield from plan_experiment(
            self.cell,
            self.robot,
            self.collision,
            self.payload_box,
            self.stops[done:],
            start=start,
            period=self.session.period,
            planner=self.planner,
            seed=self.seed + self.restarts,
        )
        self.plan_s += plan.plan_s
        return plan

    def recording(self, log: SampleLog) -> Recording:
        """The old samples and the new ones."""
        return appended(self.before, log.recording())
