"""A session that plays a recording back, for tests and for running the on-line estimation over old data."""

from __future__ import annotations

from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

from core.errors import BadRecording, BadState
from core.recording.recording import Recording
from core.sessions.pace import AsFastAsPossible, Pace
from core.sessions.session import RobotSession, RobotState

Array = NDArray[np.float64]


class ReplaySession(RobotSession):
    """Hands out a recording sample by sample, from its beginning on every entry.

    Nothing moves, so a command changes nothing; it is checked as a robot would (n finite numbers, none after `stop()`)
    and forgotten. After `stop()` the recording goes on: what was recorded cannot be braked.

    Args:
        recording: with joint positions and the wrench. Absent joint velocities are differentiated from the positions
            (for display, not for estimation), an absent command is taken to be the position.
        pace: as fast as possible, or with the wall clock.

    Raises:
        BadRecording: no joint positions, no wrench, or fewer than two samples.
    """

    def __init__(self, recording: Recording, *, pace: Pace | None = None) -> None:
        self._q = _demanded(recording.q, "q")
        self._wrench = _demanded(recording.wrench, "wrench")
        if len(recording) < 2:
            raise BadRecording("recording", f"{len(recording)} samples", "at least two")
        self.recording = recording
        self.period = float(np.median(np.diff(recording.t)))
        self._dq = np.gradient(self._q, recording.t, axis=0) if recording.dq is None else recording.dq
        self._q_cmd = self._q if recording.q_cmd is None else recording.q_cmd
        self._pace = pace or AsFastAsPossible()
        self._row = 0
        self._open = False
        self._stopped = False

    def __len__(self) -> int:
        """Samples that are left."""
        return len(self.recording) - self._row

    def __enter__(self) -> Self:
        self._row = 0
        self._open = True
        self._stopped = False
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._open = False

    def state(self) -> RobotState:
        """The next sample. See `RobotSession.state`.

        Raises:
            BadState: the recording has ended.
        """
        self._demand_open("state()")
        k, r = self._row, self.recording
        if k == len(r):
            raise BadState(
                f"the recording ends after {k} samples, at t = {r.t[-1]:.3f} s; stop at len(session) == 0.",
                value=float(k),
                limit=float(k),
            )
        self._row += 1
        self._pace.wait_until(float(r.t[k]))
        return RobotState(
            t=float(r.t[k]),
            q=self._q[k],
            dq=self._dq[k],
            q_cmd=self._q_cmd[k],
            wrench=self._wrench[k],
            tau=None if r.tau is None else r.tau[k],
            temperature=None if r.temperature is None else float(r.temperature[k]),
        )

    def command(self, q: Array) -> None:
        """Checks the command and forgets it.

        Raises:
            BadState: after a stop, or q is not n finite numbers.
        """
        self._demand_open("command()")
        if self._stopped:
            raise BadState("a command after a stop; call release() to go on.", value=1.0, limit=0.0)
        q = np.asarray(q, dtype=float)
        if q.shape != self._q.shape[1:] or not np.isfinite(q).all():
            raise BadState(
                f"command {q.tolist()}: expected {self._q.shape[1]} finite joint positions.",
                value=float(np.count_nonzero(~np.isfinite(q))),
                limit=0.0,
            )

    def stop(self) -> None:
        """Refuses further commands."""
        self._stopped = True

    def release(self) -> None:
        """Accepts commands again."""
        self._stopped = False

    def _demand_open(self, call: str) -> None:
        if not self._open:
            raise RuntimeError(f"{call} outside of the session; use it inside `with session:`")


def _demanded(column: Array | None, name: str) -> Array:
    if column is None:
        raise BadRecording(f"recording: {name}", "none", "a column of it: a replay needs joint positions and the wrench")
    return column
