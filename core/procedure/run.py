"""A run of a robot: it moves along a plan, and after a stop by the guard along a plan for the rest."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.control.execute import execute
from core.control.guard import Guard
from core.control.movers import Mover, Playback, StandStill
from core.control.rotation import Rotation
from core.errors import Held, Stopped
from core.events import Event, PhaseStarted, Progress, RobotStopped, StepFinished, TargetReached
from core.payload.shapes import StandingShape
from core.planning.joint_torques import Load
from core.planning.plan import Leg, Plan
from core.planning.settings import Planner
from core.planning.stops import PlanRequest, Stops
from core.procedure.early_end import EarlyEnd, is_last_turn
from core.procedure.recorder import Recorder
from core.procedure.target_watch import TargetWatch
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.sessions.session import RobotSession, RobotState
from core.words.message import Message

MAX_RESTARTS = 3
"""How often the guard may stop a run before it is given up."""

BATCH_S = 0.02
"""How often samples are handed on while the robot moves."""


class _Motion(NamedTuple):
    """One motion of a plan.

    Args:
        lasts_s: as planned, s.
        toward: where it ends, of a transfer.
        last: whether no rotation comes after it.
    """

    phase: str
    mover: Mover
    lasts_s: float
    toward: str = ""
    last: bool = False


@dataclass(frozen=True)
class Planning:
    """How the plans of a run are found: here, by this process.

    Args:
        stops: what the robot goes through.
        planner: of the paths.
        seed: of the first plan; another one after each stop gives other start configurations.
        effort: how much is searched before a plan is refused, see `core.planning.effort`.
        load: what the joints' torques are judged with; guessed where nothing is known of it.
    """

    stops: Stops
    planner: Planner = "rrt_connect"
    seed: int = 0
    effort: int = 1
    load: Load | None = None

    def find_plan(self, run: Run, start: Array) -> Generator[Event, None, Plan]:
        """A plan through what is left of a run, from joint positions `start` (n,), rad, where the robot stands."""
        return self.stops.plan(self.request(run, start), run.robot, run.collision)

    def request(self, run: Run, start: Array) -> PlanRequest:
        """What is to be planned, for whoever plans it."""
        seed = self.seed + run.restarts
        return PlanRequest(run.cell, run.payload_box, start, run.done, run.session.period, self.planner, seed, self.load, self.effort)


class Run:
    """One robot in one cell: plans its stops, moves, and plans the rest anew after a stop by the guard.

    Args:
        robot: of the cell.
        planning: finds the plans.
        recorder: takes the samples.
        done: steps that are finished already, by a run that this one goes on with.
        plan_s: time that planning has taken already, s.
        watch: of the run's target, where it has one: what need not be done any more is left out, and the robot goes home.
    """

    def __init__(
        self,
        cell: Cell,
        robot: RobotModel,
        session: RobotSession,
        payload_box: Box,
        planning: Planning,
        recorder: Recorder,
        *,
        done: int = 0,
        plan_s: float = 0.0,
        watch: TargetWatch | None = None,
    ) -> None:
        self.cell, self.robot, self.session, self.payload_box = cell, robot, session, payload_box
        self.planning, self.recorder = planning, recorder
        self.collision = CollisionModel(cell, robot, payload_box)
        self.guard = Guard(cell, robot, self.collision, period=session.period, late_s=session.late_s)
        self.steps = len(planning.stops) + 1
        """All legs, and the way home."""
        self.done = done
        """Steps that are finished: of the plan, and of a run that this one goes on with."""
        self.early_end = EarlyEnd(watch, recorder.log)
        self.restarts = 0
        self.plan_s = plan_s
        self._moved_s = 0.0
        """Of all plans so far: what it stood on hold or was planned in between does not count."""

    def make_plan(self, start: Array) -> Generator[Event, None, Plan]:
        """A plan through what is left to do, from joint positions `start` (n,), rad, where the robot stands."""
        plan = yield from self.planning.find_plan(self, start)
        self.plan_s += plan.plan_s
        return plan

    def execute_plan(self, plan: Plan) -> Generator[Event, None, Plan]:
        """Carries the plan out; after a stop by the guard the rest of it from new start configurations, as the paper says.

        Returns the last plan.
        """
        while True:
            try:
                yield from self._follow(plan)
            except Stopped as error:
                final = self.restarts >= MAX_RESTARTS or not error.may_go_on
                here = self._record_braking()
                yield self._describe_stop(error, final=final)
                if final:
                    raise
                self.restarts += 1
                plan = yield from self.make_plan(here)
                self.session.release()
            else:
                return plan

    def change_zone(self, name: str, shape: StandingShape | None) -> None:
        """A zone has moved, grown, come or gone (None): the guard sees it at its next look, later plans keep clear of it (world frame).

        To be called between two events.
        """
        self.collision.change_zone(name, shape)
        self.cell = self.cell.with_zone(name, shape)

    def _follow(self, plan: Plan) -> Generator[Event, None, None]:
        """Leg after leg, then home. Where the target is reached, home on the stop's own way, or along what is left of the plan."""
        left_s, home = plan.robot_s, plan.home.trajectory
        for k, leg in enumerate(plan.legs):
            made = -1  # without the transfer
            for motion in self._motions(leg, plan):
                left_s -= motion.lasts_s
                yield from self._move(motion, left_s, self.done + 1)
                made += 1
            left_s -= self.early_end.skip_rest(leg, plan.timing, made)
            reached = self.early_end.reached
            if not reached:
                self.done += 1
                yield StepFinished(step=self.done, steps=self.steps)
            elif self.done < self.steps - 1:
                self.done = self.steps - 1
                yield TargetReached(made=self.early_end.made, message=Message.of("target-reached-home"))
                yield StepFinished(step=self.done, steps=self.steps)
            if reached and leg.home is not None:
                self.early_end.skip_legs(plan, k)
                home = leg.home.transfer.trajectory
                break
        yield from self._move(_Motion("transfer", Playback(home), home.duration, "home"), 0.0, self.steps)

    def _motions(self, leg: Leg, plan: Plan) -> Generator[_Motion, None, None]:
        """Transfer, motionless phase, and where there is one the movement and another motionless phase; each made when it is its turn."""
        hold = f"hold:{leg.axis}"
        yield _Motion("transfer", Playback(leg.transfer.trajectory), leg.transfer.trajectory.duration, leg.axis)
        if self.early_end.reached:
            return
        yield self._hold(hold, plan.timing.hold_s)
        if leg.moving_s == 0.0 or self.early_end.reached:
            return
        if leg.profile is not None:
            speed = self.cell.limits.cartesian_speed_m_s
            axis = "xyz".index(leg.about)
            points, limits = self.collision.points, self.guard.limits
            turn = Rotation(self.robot, points, limits, cartesian_speed=speed, profile=leg.profile, axis=axis)
            yield _Motion(f"rotate:{leg.about}", turn, leg.profile.duration, last=is_last_turn(leg, plan))
        if leg.wave is not None:
            yield _Motion("transfer", Playback(leg.wave), leg.wave.duration, leg.axis)
        yield self._hold(hold, plan.timing.settle_s)

    def _hold(self, phase: str, lasts_s: float) -> _Motion:
        return _Motion(phase, StandStill(lasts_s, self.session.period), lasts_s)

    def _move(self, motion: _Motion, after_s: float, step: int) -> Generator[Event, None, None]:
        """One motion: its samples to the recorder, its progress as events.

        Where the robot is put on hold it brakes and keeps its place. Who drives this generator asks for the next event when it may go on;
        it then goes on from where it stands, along the same motion.

        Args:
            after_s: how long everything takes that follows it.
        """
        phase, mover = motion.phase, motion.mover
        ends_s = self._moved_s + motion.lasts_s
        size = max(1, round(BATCH_S / self.session.period))
        while True:
            yield PhaseStarted(phase=phase, toward=motion.toward, step=step, steps=self.steps)
            try:
                for batch in execute(self.session, self.guard, mover, phase, batch=size):
                    self.recorder.take(batch.states, batch.phase)
                    self._moved_s += len(batch.states) * self.session.period
                    if isinstance(mover, Rotation):
                        ends_s -= self.early_end.look(mover, last=motion.last)
                    total_s = max(ends_s, self._moved_s) + after_s
                    yield Progress(phase=phase, done_s=self._moved_s, total_s=total_s, estimate_phi=self.recorder.phi)
            except Held as held:
                here = self._record_braking()
                yield self._describe_stop(held, final=False, held=True)
                mover.resume(here)
                self.session.release()
            else:
                if phase != "transfer":
                    self.early_end.count_motion()
                return

    def _describe_stop(self, error: Stopped, *, final: bool, held: bool = False) -> RobotStopped:
        restart = self.restarts + (not held)  # a pause costs no attempt
        kind = type(error).__name__
        return RobotStopped(error=kind, message=error.message, restart=restart, final=final, held=held, lateness=error.lateness)

    def _record_braking(self) -> Array:
        """Records the braking until the command stands still, and returns it."""
        states: list[RobotState] = []
        try:
            while True:
                states.append(self.session.state())
                if len(states) > 1 and np.array_equal(states[-1].q_cmd, states[-2].q_cmd, equal_nan=True):
                    return states[-1].q_cmd
        finally:
            self.recorder.take_braking(states)
