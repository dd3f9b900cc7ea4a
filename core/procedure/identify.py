"""The whole procedure of the paper (Fig. 2-3) from top to bottom: plan, move, hold, rotate, estimate.

`identify` is a generator of events that returns the outcome: no threads, no callbacks. The command line prints the events, a test drains
them. `carry_out` is the same for a plan that has been shown and released already.
"""

from __future__ import annotations

import time
from collections.abc import Generator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.cell.cell import Box, Cell, Payload, Pose
from core.control.execute import execute
from core.control.guard import Guard
from core.control.movers import Mover, Playback, StandStill
from core.control.rotation import Rotation
from core.errors import Held, Interrupted, Refused, Stopped
from core.estimation.identification import identify_recording
from core.estimation.online import OnlineEstimator
from core.events import Event, Finished, PhaseStarted, Progress, RecordingWritten, RobotStopped, StepFinished
from core.planning.joint_torques import Load, find_known_load
from core.planning.plan import Leg, Plan
from core.planning.sequence import MotionSequence, PlanRequest, Procedure
from core.planning.settings import WHOLE, Planner, Scope, Timing
from core.procedure.outcome import Outcome
from core.recording.folder import write_recording
from core.recording.recording import Recording
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotSession, RobotState
from core.twin.twin import NOMINAL, Twin

Array = NDArray[np.float64]

MAX_RESTARTS = 3
"""How often the guard may stop a run before it is given up."""

BATCH_S = 0.02
"""How often samples are handed on while the robot moves."""


def identify(
    cell: Cell,
    session: RobotSession,
    payload_box: Box,
    *,
    payload: str | None = None,
    reference: Payload | None = None,
    timing: Timing | None = None,
    mass_guess_kg: float = 1.0,
    scope: Scope = WHOLE,
    start: Array | None = None,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    effort: int = 1,
    out: Path | None = None,
    twin: Twin = NOMINAL,
) -> Generator[Event, None, Outcome]:
    """Finds out what the robot carries: plans, carries the plan out, estimates.

    Args:
        cell: where the robot stands, with its limits.
        session: the robot; entered and left here.
        payload_box: what certainly contains the payload, sensor frame. Nothing else need be known of it.
        payload, reference: name and reference values, written into the recording; the joints' torques are judged with the payload of that
            name where the cell knows it.
        timing: holds, accuracy and robot time.
        mass_guess_kg: what repetitions are planned for until the mass is known.
        scope: what of the procedure is wanted.
        start: (n,), where the robot stands, rad; at home where absent.
        planner: of the paths.
        seed: of planning.
        effort: how much is searched before a plan is refused, see `core.planning.effort`.
        out: folder to make for the recording; nothing is written where absent.
        twin: of the cell; the estimate accounts for its effects.

    Raises:
        Refused: the cell leaves no safe way; the robot has not moved.
        Stopped: the guard stopped the robot more often than may be; the recording is written.
        Interrupted: Ctrl-C; the robot is stopped and the recording written.
    """
    run = Run(cell, session, payload_box, Procedure(timing or Timing(), mass_guess_kg, scope), planner, seed)
    run.twin, run.load, run.effort = twin, find_known_load(cell, payload), effort
    plan = yield from run.make_plan(np.array(cell.robot.home_rad) if start is None else start)
    return (yield from move_and_estimate(run, plan, payload, reference, out))


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
    run = Run(cell, session, payload_box, Procedure(plan.timing, mass_guess_kg), "rrt_connect", seed)
    run.plan_s, run.twin, run.load = plan.plan_s, twin, find_known_load(cell, payload)
    return (yield from move_and_estimate(run, plan, payload, reference, out))


def move_and_estimate(
    run: Run, plan: Plan, payload: str | None, reference: Payload | None, out: Path | None
) -> Generator[Event, None, Outcome]:
    """Moves, closes the recording whatever ended the motion, and estimates."""
    log = SampleLog(run.cell, run.robot, payload=payload, reference=reference, before=run.before)
    try:
        with run.session:
            plan = yield from run.execute_plan(plan, log)
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
    identification = identify_recording(recording, run.twin)
    estimate_s = time.perf_counter() - began
    yield Finished(verdict=identification.verdict)
    return Outcome(
        cell=run.cell,
        payload_box=run.payload_box,
        plan=plan,
        recording=recording,
        identification=identification,
        safety=run.guard.record,
        distances=np.array(run.guard.distances).reshape(-1, 2),
        restarts=run.restarts,
        plan_s=run.plan_s,
        robot_s=log.seconds,
        estimate_s=estimate_s,
        seed=run.seed,
    )


def _write_log(log: SampleLog, out: Path | None) -> Generator[Event, None, None]:
    """The recording on disk, if it is wanted and there is anything to write."""
    if out is None or not len(log):
        return
    recording = log.recording()
    write_recording(recording, out)
    yield RecordingWritten(folder=str(out), samples=len(recording))


class Run:
    """One robot in one cell: plans a sequence of motions, moves, and plans the rest anew after a stop."""

    twin: Twin = NOMINAL
    """What the estimate accounts for."""
    load: Load | None = None
    """What the joints' torques are judged with; guessed where nothing is known of it."""
    before: Recording | None = None
    """What the samples are appended to; of this robot as it stands here (`recording.check_same_robot`)."""
    effort: int = 1
    """How much is searched before a plan is refused."""

    def __init__(self, cell: Cell, session: RobotSession, payload_box: Box, sequence: MotionSequence, planner: Planner, seed: int) -> None:
        self.cell, self.session, self.payload_box = cell, session, payload_box
        self.sequence, self.planner, self.seed = sequence, planner, seed
        self.robot = RobotModel.of_cell(cell)
        self.collision = CollisionModel(cell, self.robot, payload_box)
        self.guard = Guard(cell, self.robot, self.collision, period=session.period)
        noise = np.array(cell.sensor.noise_std)
        self.online = OnlineEstimator(self.robot, cell.gravity, period=session.period, noise_std=noise)
        self.done = 0
        """Steps that are finished: of the plan, and of a run that this one goes on with."""
        self.restarts = 0
        self.plan_s = 0.0

    def make_plan(self, start: Array, done: int = 0) -> Generator[Event, None, Plan]:
        """A plan through what is left to do after so many legs, from where the robot stands.

        Another seed after each stop gives other start configurations.
        """
        plan = yield from self.sequence.plan_legs(self.plan_request(start, done), self.robot, self.collision)
        self.plan_s += plan.plan_s
        return plan

    def plan_request(self, start: Array, done: int) -> PlanRequest:
        """What is to be planned from joint positions `start` (n,), rad, after so many legs, for whoever plans it."""
        seed = self.seed + self.restarts
        return PlanRequest(self.cell, self.payload_box, start, done, self.session.period, self.planner, seed, self.load, self.effort)

    def execute_plan(self, plan: Plan, log: SampleLog) -> Generator[Event, None, Plan]:
        """Carries the plan out; after a stop by the guard the rest of it from new start configurations, as the paper says.

        Returns the last plan.
        """
        while True:
            try:
                for leg in plan.legs:
                    yield from self.leg(leg, log, plan, step=self.done + 1)
                    self.done += 1
                    yield StepFinished(step=self.done, steps=self.sequence.steps + 1)
                yield from self.phase("transfer", "home", Playback(plan.home.trajectory), log, plan, step=self.sequence.steps + 1)
            except Stopped as error:
                final = self.restarts >= MAX_RESTARTS or not error.may_go_on
                here = self._record_braking(log)
                yield self._describe_stop(error, final=final)
                if final:
                    raise
                self.restarts += 1
                plan = yield from self.make_plan(here, self.done)
                self.session.release()
            else:
                return plan

    def _describe_stop(self, error: Stopped, *, final: bool, held: bool = False) -> RobotStopped:
        restart = self.restarts + (not held)  # a pause costs no attempt
        kind = type(error).__name__
        return RobotStopped(error=kind, message=error.message, restart=restart, final=final, held=held, lateness=error.lateness)

    def _record_braking(self, log: SampleLog) -> Array:
        """Records the braking until the command stands still, and returns it."""
        before = None
        while True:
            state = self.session.state()
            log.extend([state], "transfer")
            if before is not None and np.array_equal(state.q_cmd, before, equal_nan=True):
                return state.q_cmd
            before = state.q_cmd

    def move_zone(self, name: str, pose: Pose) -> None:
        """A zone or an obstacle has moved (world frame): the guard sees it at its next look, later plans keep clear of it.

        To be called between two events.

        Raises:
            BadCell: there is none of that name.
        """
        self.collision.move(name, pose)
        self.cell = self.cell.with_pose_of(name, pose)

    def leg(self, leg: Leg, log: SampleLog, plan: Plan, *, step: int) -> Generator[Event, None, None]:
        """Transfer, motionless phase, and where there is one the movement and another motionless phase."""
        hold = f"hold:{leg.axis}"
        period = self.session.period
        yield from self.phase("transfer", leg.axis, Playback(leg.transfer.trajectory), log, plan, step=step)
        yield from self.phase(hold, "", StandStill(plan.timing.hold_s, period), log, plan, step=step)
        if leg.profile is not None:
            rotation = Rotation(
                self.robot,
                self.collision.points,
                self.guard.limits,
                cartesian_speed=self.cell.limits.cartesian_speed_m_s,
                profile=leg.profile,
                axis="xyz".index(leg.about),
            )
            yield from self.phase(f"rotate:{leg.about}", "", rotation, log, plan, step=step)
        if leg.wave is not None:
            yield from self.phase("transfer", leg.axis, Playback(leg.wave), log, plan, step=step)
        if leg.moving_s > 0.0:
            yield from self.phase(hold, "", StandStill(plan.timing.settle_s, period), log, plan, step=step)

    def phase(self, phase: str, toward: str, mover: Mover, log: SampleLog, plan: Plan, *, step: int) -> Generator[Event, None, None]:
        """One motion: its samples into the log, its progress as events.

        Where the robot is put on hold it brakes and keeps its place. Who drives this generator asks for the next event when it may go on;
        it then goes on from where it stands, along the same motion.
        """
        size = max(1, round(BATCH_S / self.session.period))
        while True:
            yield PhaseStarted(phase=phase, toward=toward, step=step, steps=self.sequence.steps + 1)
            try:
                for batch in execute(self.session, self.guard, mover, phase, batch=size):
                    known = self.update_estimate(log.extend(batch.states, batch.phase))
                    yield Progress(phase=phase, done_s=log.seconds, total_s=max(plan.robot_s, log.seconds), estimate_phi=known)
            except Held as held:
                here = self._record_braking(log)
                yield self._describe_stop(held, final=False, held=True)
                mover.resume(here)
                self.session.release()
            else:
                return

    def update_estimate(self, states: Sequence[RobotState]) -> tuple[float | None, ...]:
        """The estimate along the way, after some more samples; None where a parameter is not yet known."""
        for state in states:
            self.online.update(state.q, state.wrench)
        return tuple(float(value) if np.isfinite(value) else None for value in self.online.so_far.phi)
