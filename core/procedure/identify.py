"""A run from top to bottom: plan, move, hold, rotate, estimate. It stops where the paper's procedure (Fig. 2-3) does, or elsewhere.

`identify` is a generator of events that returns the outcome: no threads, no callbacks. The command line prints the events, a test drains
them (`core.events.drive`). `carry_out` is the same for a plan that has been shown and released already.
"""

from __future__ import annotations

import time
from collections.abc import Generator
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell, Payload
from core.errors import Interrupted, Refused, Stopped
from core.estimation.identification import identify_recording
from core.events import Event, Finished, RecordingWritten
from core.planning.joint_torques import Load, find_known_load
from core.planning.plan import Plan
from core.planning.settings import Planner
from core.planning.stops import PROCEDURE, Stops
from core.procedure.outcome import Outcome
from core.procedure.recorder import Recorder, build_estimator
from core.procedure.run import Planning, Run
from core.procedure.target_watch import WatchHere
from core.recording.folder import write_recording
from core.recording.recording import Recording, check_arm_alone, check_same_robot
from core.requirement.target import CellRequirement, Target, TargetCheck
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotSession
from core.twin.twin import NOMINAL, Twin


def identify(
    cell: Cell,
    session: RobotSession,
    payload_box: Box,
    *,
    stops: Stops | None = None,
    before: Recording | None = None,
    payload: str | None = None,
    reference: Payload | None = None,
    load: Load | None = None,
    start: Array | None = None,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    effort: int = 1,
    out: Path | None = None,
    twin: Twin = NOMINAL,
    target: Target | None = None,
    clock_waits: bool = True,
    without: Recording | None = None,
) -> Generator[Event, None, Outcome]:
    """Finds out what the robot carries: plans, carries the plan out, estimates.

    Args:
        cell: where the robot stands, with its limits.
        session: the robot; entered and left here.
        payload_box: what certainly contains the payload, sensor frame. Nothing else need be known of it.
        stops: what the robot goes through; the whole procedure where absent.
        before: a recording that is continued; only read. The outcome's recording holds its samples and, after a gap in time, the new ones.
        payload, reference: name and reference values, written into the recording; the name is that of a recording that is continued where
            absent.
        load: what the joints' torques are judged with; the payload of that name where absent and the cell knows it.
        start: (n,), where the robot stands, rad; at home where absent.
        planner: of the paths.
        seed: of planning.
        effort: how much is searched before a plan is refused, see `core.planning.effort`.
        out: folder to make for the recording; nothing is written where absent.
        twin: of the cell; the estimate accounts for its effects.
        target: how exactly; what is not needed for it is left out, and the robot goes home.
        without: a recording of the arm without the payload, to tell it by the joints' torques; only read.
        clock_waits: whether the session's clock stands while nobody asks it, so that estimating on the way costs no robot time.

    Raises:
        BadInput: the recording that is continued, or the one without the payload, is not of this cell's robot as it stands.
        Refused: the cell leaves no safe way; the robot has not moved.
        Stopped: the guard stopped the robot more often than may be; the recording is written.
        Interrupted: Ctrl-C; the robot is stopped and the recording written.
    """
    robot = RobotModel.of_cell(cell)
    if before is not None:
        check_same_robot(before, robot.description, cell.gravity_in_base)
        payload = payload or before.payload
    if without is not None:
        check_arm_alone(without, robot.description, cell.gravity_in_base)
    log = SampleLog(cell, robot, payload=payload, reference=reference, before=before, complete=session.complete)
    recorder = Recorder(log, build_estimator(log, session.period))
    stops = stops or PROCEDURE
    planning = Planning(
        stops if target is None else replace(stops, target=target), planner, seed, effort, load or find_known_load(cell, payload)
    )
    check = None if target is None else TargetCheck(target, CellRequirement(cell, robot))
    watch = None if check is None else WatchHere(check, twin, clock_waits=clock_waits)
    run = Run(cell, robot, session, payload_box, planning, recorder, watch=watch)
    plan = yield from run.make_plan(np.array(cell.robot.home_rad) if start is None else start)
    return (yield from move_and_estimate(run, plan, twin, out, without))


def carry_out(
    cell: Cell,
    session: RobotSession,
    payload_box: Box,
    plan: Plan,
    *,
    payload: str | None = None,
    reference: Payload | None = None,
    mass_guess_kg: float = 1.0,
    seed: int = 0,
    out: Path | None = None,
    twin: Twin = NOMINAL,
) -> Generator[Event, None, Outcome]:
    """The second half of `identify`, for a plan that starts where the robot stands. Arguments and errors as there."""
    robot = RobotModel.of_cell(cell)
    log = SampleLog(cell, robot, payload=payload, reference=reference, complete=session.complete)
    recorder = Recorder(log, build_estimator(log, session.period))
    stops = Stops(tuple(leg.stop for leg in plan.legs), plan.timing, mass_guess_kg)
    planning = Planning(stops, seed=seed, load=find_known_load(cell, payload))
    run = Run(cell, robot, session, payload_box, planning, recorder, plan_s=plan.plan_s)
    return (yield from move_and_estimate(run, plan, twin, out))


def move_and_estimate(
    run: Run, plan: Plan, twin: Twin, out: Path | None, without: Recording | None = None
) -> Generator[Event, None, Outcome]:
    """Moves, closes the recording whatever ended the motion, and estimates.

    Args:
        plan: from where the robot stands.
        twin, out, without: as in `identify`.
    """
    log = run.recorder.log
    try:
        with run.session:
            plan = yield from run.execute_plan(plan)
    except (Stopped, Refused):
        yield from _write_log(log, out)
        raise
    except KeyboardInterrupt:
        yield from _write_log(log, out)
        if out is None:
            raise Interrupted("procedure-interrupted", moved_s=log.seconds) from None
        raise Interrupted("procedure-interrupted-recorded", moved_s=log.seconds, folder=str(out)) from None
    yield from _write_log(log, out)
    recording = log.recording()
    began = time.perf_counter()
    identification = identify_recording(recording, twin, without)
    estimate_s = time.perf_counter() - began
    requirement = judge_estimate(run.cell, run.robot, identification.estimate)
    target = run.early_end.answer_target(identification.estimate)
    yield Finished(verdict=identification.verdict)
    return Outcome(
        cell=run.cell,
        payload_box=run.payload_box,
        plan=plan,
        recording=recording,
        identification=identification,
        requirement=requirement,
        target=target,
        safety=run.guard.record,
        distances=np.array(run.guard.distances).reshape(-1, 2),
        restarts=run.restarts,
        plan_s=run.plan_s,
        robot_s=log.seconds,
        estimate_s=estimate_s,
        seed=run.planning.seed,
    )


def _write_log(log: SampleLog, out: Path | None) -> Generator[Event, None, None]:
    """The recording on disk, if it is wanted and there is anything to write."""
    if out is None or not len(log):
        return
    recording = log.recording()
    write_recording(recording, out)
    yield RecordingWritten(folder=str(out), samples=len(recording))
