"""What a run is made of in the control process: planned elsewhere, its zones alive, its samples on disk and on their way to who watches."""

from __future__ import annotations

import time
from collections.abc import Generator, Sequence
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.errors import Commanded
from core.estimation.online import OnlineEstimator
from core.estimation.result_part import Numbers, to_json_numbers
from core.events import Event, Progress
from core.payload.rigid_wrench import wrench
from core.planning.plan import Plan
from core.procedure.recorder import Recorder
from core.procedure.run import Planning, Run
from core.sessions.leased import Lease
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState
from server.runner.live_schemas import LiveBatch, NearestPart, WaitingForZone
from server.runner.messages import FromChild, Sampled
from server.runner.pipe import Listener, Speaker
from server.runner.planning import PlanningProcess, PlanRefused
from server.runner.sample_stream import SampleStream

LIVE_PERIOD_S = 0.02
"""Of what is sent to who watches: 50 batches a second."""
PAUSE_S = 1.0
"""A robot that is not heard of for longer stood, on hold or while it was planned for anew: that says nothing of how fast it moves."""
LIVE_ROWS = 20
"""Samples in such a batch, at most."""


@dataclass(frozen=True, kw_only=True)
class PlanningElsewhere(Planning):
    """How the plans of a run are found by another process, the first time and after every stop.

    Args:
        process: plans.
        listener, lease: whether zones have changed, and whether the run was ended meanwhile.
    """

    process: PlanningProcess
    listener: Listener
    lease: Lease

    def find_plan(self, run: Run, start: Array) -> Generator[Event, None, Plan]:
        """A plan through what is left of a run, from joint positions `start` (n,), rad, where the robot stands.

        Where a zone that moves has stopped the robot and leaves no way, it stands and waits until the zone moves on.

        Raises:
            PlanRefused: there is no safe way, and nothing has moved yet.
            Commanded: the run was ended meanwhile.
        """
        while True:
            look_at_zones(run, self.listener)
            cell = run.cell
            try:
                return (yield from self.process.ask(self.request(run, start), self._refuse_ended))
            except PlanRefused as refusal:
                if not len(run.recorder.log) or not run.cell.zones:
                    raise
                yield WaitingForZone(message=refusal.message, in_the_way=refusal.failed.in_the_way)
                while run.cell is cell and not self.listener.zones:
                    if self.listener.ended.wait(0.02):
                        raise make_end_error(self.lease) from None

    def _refuse_ended(self) -> None:
        if self.listener.ended.is_set():
            raise make_end_error(self.lease)


def make_end_error(lease: Lease) -> Commanded:
    """Why a run was ended."""
    refusal = lease.refusal()
    return refusal if isinstance(refusal, Commanded) else Commanded("runs-ended", value=1.0, limit=0.0)


def look_at_zones(run: Run, listener: Listener) -> None:
    """Zones that have changed since the last look. To be called between two events of the run."""
    while listener.zones:
        changed = listener.zones.popleft()
        run.change_zone(changed.zone, changed.shape)


class DiskRecorder(Recorder):
    """Has every batch of samples on disk before anybody hears of it.

    Args:
        stream: open.
    """

    def __init__(self, log: SampleLog, online: OnlineEstimator, stream: SampleStream) -> None:
        super().__init__(log, online)
        self._stream, self._written = stream, 0

    def take(self, states: Sequence[RobotState], phase: str) -> None:
        """Samples of a motion."""
        super().take(states, phase)
        self._append()

    def take_braking(self, states: Sequence[RobotState]) -> None:
        """Samples of a robot that brakes."""
        super().take_braking(states)
        self._append()

    def _append(self) -> None:
        """What is new goes to disk."""
        if len(self.log) > self._written:
            self._stream.append(self.log.states[self._written :], self.log.phases[self._written :])
            self._written = len(self.log)


class LiveView:
    """The newest samples of a run, for those who watch it.

    Args:
        online: estimates along the way.
    """

    def __init__(self, run: Run, online: OnlineEstimator, speaker: Speaker[FromChild]) -> None:
        self._collision, self._log, self._online, self._speaker = run.collision, run.recorder.log, online, speaker
        self._sent_s, self._heard_s, self._moved_s = -np.inf, np.inf, 0.0

    def show(self, progress: Progress) -> None:
        """The newest samples to who watches, at most every `LIVE_PERIOD_S` of the wall clock."""
        now = time.monotonic()
        self._moved_s += min(max(now - self._heard_s, 0.0), PAUSE_S)
        self._heard_s = now
        if now - self._sent_s < 0.9 * LIVE_PERIOD_S or not len(self._log):
            return
        self._sent_s = now
        self._speaker.tell(Sampled(self._batch(progress, wall_s=self._moved_s)))

    def _batch(self, progress: Progress, *, wall_s: float) -> LiveBatch:
        states = self._log.states[-LIVE_ROWS:]
        estimate, motion = self._online.so_far, self._online.motion
        known = np.where(np.isfinite(estimate.phi), estimate.phi, 0.0)  # the paper leaves the products of inertia out
        expected = wrench(motion, known)[0] + estimate.offset
        nearest = self._collision.obstacle_distance(states[-1].q)
        return LiveBatch(
            phase=progress.phase,
            t_s=[round(state.t, 6) for state in states],
            wrench=np.round([state.wrench for state in states], 6).tolist(),
            reconstructed=np.round(expected, 6).tolist() if np.isfinite(expected).all() and np.isfinite(estimate.phi[0]) else None,
            phi=_round_numbers(estimate.phi),
            phi_std=_round_numbers(estimate.std),
            q_rad=np.round(states[-1].q, 6).tolist(),
            nearest=NearestPart(
                distance_m=round(nearest.distance_m, 5),
                first=nearest.first,
                second=nearest.second,
                point_first_m=np.round(nearest.point_first, 4).tolist(),
                point_second_m=np.round(nearest.point_second, 4).tolist(),
            )
            if np.isfinite(nearest.distance_m)
            else None,
            progress=round(progress.done_s / progress.total_s, 5),
            eta_s=round((progress.total_s / progress.done_s - 1.0) * wall_s, 1) if progress.done_s > 0.0 else None,
        )


def _round_numbers(values: Array) -> Numbers:
    """Seven digits, more than any of them is known to; null for NaN."""
    return to_json_numbers(np.array([float(f"{value:.7g}") for value in values]))
