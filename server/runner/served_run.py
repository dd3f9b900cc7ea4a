"""The procedure as the control process runs it: planned elsewhere, its zones alive, its samples on disk and on their way to who watches."""

from __future__ import annotations

import time
from collections.abc import Generator
from typing import cast

import numpy as np
from numpy.typing import NDArray

from core.errors import Commanded
from core.estimation.result import to_json_numbers
from core.events import Event, Progress
from core.payload.rigid_wrench import wrench
from core.planning.plan import Plan
from core.procedure.identify import Run
from core.sessions.leased import LeasedSession
from core.sessions.sample_log import SampleLog
from server.runner.live_schemas import LiveBatch, NearestPart, WaitingForZone
from server.runner.messages import FromChild, Order, Sampled
from server.runner.pipe import Listener, Speaker
from server.runner.planning import PlanningProcess, PlanRefused
from server.runner.sample_stream import SampleStream

Array = NDArray[np.float64]

LIVE_PERIOD_S = 0.02
"""Of what is sent to who watches: 50 batches a second."""
LIVE_ROWS = 20
"""Samples in such a batch, at most."""


class ServedRun(Run):
    """One robot, told what to do by a server.

    Args:
        session: the robot under its lease.
        planning: plans the first time and after every stop.
    """

    def __init__(
        self, order: Order, session: LeasedSession, planning: PlanningProcess, listener: Listener, speaker: Speaker[FromChild]
    ) -> None:
        super().__init__(order.cell, session, order.payload_box, planning.sequence, order.planner, order.seed)
        self._lease, self._planning, self._listener, self._speaker = session.lease, planning, listener, speaker
        self._stream = SampleStream(order.folder)
        self._written = 0
        self._sent_s, self._began_s = -np.inf, np.inf

    def make_plan(self, start: Array, done: int = 0) -> Generator[Event, None, Plan]:
        """Has the planning process plan what is left to do after `done` steps, from `start` (n,), rad; returns the plan.

        Where a zone that moves has stopped the robot and leaves no way, it stands and waits until the zone moves on.

        Raises:
            PlanRefused: there is no safe way, and nothing has moved yet.
            Commanded: the run was ended meanwhile.
        """
        while True:
            self.look_at_zones()
            cell = self.cell
            try:
                plan = yield from self._ask(start, done)
            except PlanRefused as refusal:
                if self._written == 0 or not self.cell.zones:
                    raise
                yield WaitingForZone(message=refusal.message, in_the_way=refusal.failed.in_the_way)
                while self.cell is cell and not self._listener.zones:
                    if self._listener.ended.wait(0.02):
                        raise self.make_end_error() from None
            else:
                self.plan_s += plan.plan_s
                return plan

    def _ask(self, start: Array, done: int) -> Generator[Event, None, Plan]:
        """One answer of the planning process."""
        asked = self._planning.ask(self.plan_request(start, done))
        while True:
            try:
                event = next(asked)
            except StopIteration as end:
                return cast("Plan", end.value)
            if self._listener.ended.is_set():
                raise self.make_end_error()
            if event is not None:
                yield event

    def make_end_error(self) -> Commanded:
        """Why the run was ended."""
        refusal = self._lease.refusal()
        return refusal if isinstance(refusal, Commanded) else Commanded("runs-ended", value=1.0, limit=0.0)

    def execute_plan(self, plan: Plan, log: SampleLog) -> Generator[Event, None, Plan]:
        """Carries the plan out, after a stop by the guard its rest anew, and returns the last plan.

        Every batch of samples is on disk before its event is yielded; `log` takes them too.
        """
        moving = super().execute_plan(plan, log)
        with self._stream:
            while True:
                try:
                    event = next(moving)
                except StopIteration as end:
                    self._append(log)
                    return cast("Plan", end.value)
                self.look_at_zones()
                self._append(log)
                if isinstance(event, Progress):
                    self._show(log, event)
                try:
                    yield event
                except Commanded as error:  # ended while it stood
                    moving.throw(error)

    def look_at_zones(self) -> None:
        """Zones that have moved since the last look."""
        while self._listener.zones:
            moved = self._listener.zones.popleft()
            self.move_zone(moved.zone, moved.pose)

    def _append(self, log: SampleLog) -> None:
        """What is new goes to disk."""
        if len(log) > self._written:
            self._stream.append(log.states[self._written :], log.phases[self._written :])
            self._written = len(log)

    def _show(self, log: SampleLog, progress: Progress) -> None:
        """The newest samples to who watches, at most every `LIVE_PERIOD_S` of the wall clock."""
        now = time.monotonic()
        self._began_s = min(self._began_s, now)
        if now - self._sent_s < 0.9 * LIVE_PERIOD_S or not len(log):
            return
        self._sent_s = now
        self._speaker.tell(Sampled(self._batch(log, progress, wall_s=now - self._began_s)))

    def _batch(self, log: SampleLog, progress: Progress, *, wall_s: float) -> LiveBatch:
        states = log.states[-LIVE_ROWS:]
        estimate, motion = self.online.so_far, self.online.motion
        known = np.where(np.isfinite(estimate.phi), estimate.phi, 0.0)  # the paper leaves the products of inertia out
        expected = wrench(motion, known)[0] + estimate.offset
        nearest = self.collision.obstacle_distance(states[-1].q)
        return LiveBatch(
            phase=progress.phase,
            t_s=[round(state.t, 6) for state in states],
            wrench=np.round([state.wrench for state in states], 6).tolist(),
            reconstructed=np.round(expected, 6).tolist() if np.isfinite(expected).all() and np.isfinite(estimate.phi[0]) else None,
            phi=to_json_numbers(estimate.phi),
            phi_std=to_json_numbers(estimate.std),
            q_rad=np.round(states[-1].q, 6).tolist(),
            nearest=NearestPart(
                distance_m=nearest.distance_m,
                first=nearest.first,
                second=nearest.second,
                point_first_m=np.round(nearest.point_first, 4).tolist(),
                point_second_m=np.round(nearest.point_second, 4).tolist(),
            )
            if np.isfinite(nearest.distance_m)
            else None,
            progress=progress.done_s / progress.total_s,
            eta_s=round((progress.total_s / progress.done_s - 1.0) * wall_s, 1) if progress.done_s > 0.0 else None,
        )
