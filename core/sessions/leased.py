"""A session that obeys only while somebody is in control of the robot.

The lease is renewed by whoever answers for the motion (a person at the cell, through the server). It is checked at every command, where
commands reach the robot: nothing that fails upstream, an event loop, a pipe or a thread, can keep the robot moving. Where it runs out the
robot brakes and keeps its place; only `resume` lets it move again, whatever is renewed meanwhile.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np

from core.array import Array
from core.errors import Cause, Commanded, ControlLost, Held, HoldExpired, Lateness, Stopped
from core.sessions.session import RobotSession, RobotState
from core.words.message import Message

LEASE_S = 1.0
"""How long one renewal lasts where a cell does not say otherwise: over a usual Wi-Fi (round trip below 0.2 s in 99 %, below 0.8 s in
99.9 % of the answers) nearly every run of a minute comes through."""
SERVICE_S = 0.22
"""After how long without a sign of life the service is looked at. It is on this machine, so no network delays it: one that is frozen or
gone stops the robot within 300 ms and its braking. One that is only slow, on a computer that is busy, has as long as the console."""
FUTURE_S = 0.005
"""Stamps may be ahead of our clock by this much: clocks are read a moment apart. One from the future would not go stale."""
AWAY_S = 0.05
"""A control loop that comes back to its session after a longer time than this got no time itself."""
CATCH_UP_S = 0.05
"""What a loop that was away gives the renewals that wait in its pipe; it commands nothing meanwhile."""
LOOP_S = 0.3
"""How long a control loop may get no time; the robot's own watchdog has stopped it by then, and it does not go on by itself."""
LATE: dict[Cause, str] = {
    Cause.NETWORK: "session-late-network",
    Cause.PAGE: "session-late-page",
    Cause.SERVICE: "session-late-service",
    Cause.STORE: "session-late-store",
    Cause.CONTROL_PROCESS: "session-late-control-process",
    Cause.SENSOR: "session-late-sensor",
    Cause.ROBOT: "session-late-robot",
}
"""The message that says it, by what was late."""


@dataclass(frozen=True)
class Renewal:
    """One sign of life of whoever is in control.

    Args:
        fence: counts the holders of control; who holds an older one has lost it.
        number: counts the renewals of one fence.
        stamp_s: when it was given, `time.monotonic()` of this machine.
    """

    fence: int
    number: int
    stamp_s: float


def is_stopped(pid: int) -> bool:
    """Whether a process of this machine is frozen or gone; also where that cannot be known, on another system than Linux."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()[0]
    except OSError:
        return True
    return state in "TtZXx"


class Lease:
    """Who may command the robot, and until when. One thread writes, the control loop reads: every attribute is set in one step.

    Args:
        length_s: how long one renewal lasts.
        clock: monotonic, the one that stamps the renewals, s.
        stopped: whether the process of the service, by its number, is frozen or gone.
    """

    def __init__(
        self,
        length_s: float = LEASE_S,
        clock: Callable[[], float] = time.monotonic,
        stopped: Callable[[int], bool] = is_stopped,
    ) -> None:
        self.length_s = length_s
        self._clock, self._stopped = clock, stopped
        self._last = Renewal(fence=-1, number=-1, stamp_s=-np.inf)
        self._beat_s, self._service = np.inf, 0  # of the service; it has promised nothing before its first
        self._page = (-np.inf, 0.0)  # when the page was late last, and by how much
        self._looked_s, self._away_s = np.inf, 0.0
        self._held: Held | None = None
        self._ended: Commanded | None = None

    def renew(self, renewal: Renewal) -> bool:
        """Takes a sign of life; one that is old, repeated, out of order or from the future counts for nothing (False)."""
        now, last = self._clock(), self._last
        newer = (renewal.fence, renewal.number) > (last.fence, last.number) and renewal.stamp_s > last.stamp_s
        if not newer or not now - self.length_s < renewal.stamp_s <= now + FUTURE_S:
            return False
        self._last = renewal
        return True

    def beat(self, stamp_s: float, service: int) -> None:
        """The service lives, whether or not anybody answers it; `service` is the number of its process."""
        self._beat_s, self._service = stamp_s, service

    def note_late_page(self, late_s: float) -> None:
        """An answer came, but the page behind it has not responded for so long."""
        self._page = (self._clock(), late_s)

    def hold(self, lateness: Lateness | None = None) -> None:
        """The robot is to pause: somebody asked for it, or something that only the service sees was late."""
        if lateness is not None:
            self._held = ControlLost(LATE[lateness.cause], lateness)
        else:
            self._held = Held("session-pause-asked", value=1.0, limit=0.0)

    def resume(self) -> None:
        """It may go on, as far as the lease is valid."""
        self._held = None

    def end(self, reason: Message) -> None:
        """The robot is to stop for good."""
        ended = Commanded(reason.code, value=1.0, limit=0.0)
        ended.message = reason
        self._ended = ended

    @property
    def held(self) -> bool:
        """Whether the robot keeps its place until `resume`."""
        return self._held is not None

    @property
    def fence(self) -> int:
        """Of the present holder."""
        return self._last.fence

    @property
    def age_s(self) -> float:
        """Time since the last renewal, s."""
        return self._clock() - self._last.stamp_s

    def waits(self, hold_limit_s: float) -> bool:
        """Whether the robot is on hold and goes on waiting; a hold during which nobody has been in control for `hold_limit_s` ends."""
        age = self.age_s - self.length_s
        if self.held and age > hold_limit_s and self._ended is None:
            self._ended = HoldExpired("session-hold-expired", value=age, limit=hold_limit_s)
        return self.held and self._ended is None

    def overdue(self) -> Lateness | None:
        """What is too late now; None while the robot may be commanded."""
        now = self._clock()
        age, silent = now - self._last.stamp_s, now - self._beat_s
        if silent > SERVICE_S and self._stopped(self._service):
            cause, late, limit = Cause.SERVICE, silent, SERVICE_S
        elif age > self.length_s:
            page_at, page_late = self._page
            answered = now - page_at <= self.length_s
            cause, late, limit = (Cause.PAGE, page_late, self.length_s) if answered else (Cause.NETWORK, age, self.length_s)
            if silent > 0.5 * age:
                cause, late = Cause.SERVICE, silent
        else:
            return None
        if self._away_s > 0.5 * late:
            return Lateness(cause=Cause.CONTROL_PROCESS, late_s=self._away_s, limit_s=limit)
        return Lateness(cause=cause, late_s=min(late, 1e6), limit_s=limit)

    def begin(self) -> None:
        """The control loop begins, or goes on after a pause: it was not away."""
        self._looked_s = np.inf

    def look(self) -> bool:
        """Notes that the control loop is here; whether it was away for long."""
        now = self._clock()
        self._away_s, self._looked_s = max(0.0, now - self._looked_s), now
        return self._away_s > AWAY_S

    def refusal(self) -> Stopped | None:
        """Why the robot may not be commanded now; None if it may. What is too late holds the robot until `resume`."""
        if self._ended is not None:
            return self._ended
        if self._held is None and self._away_s > LOOP_S:
            lateness = Lateness(cause=Cause.CONTROL_PROCESS, late_s=self._away_s, limit_s=LOOP_S)
            self._held = ControlLost(LATE[lateness.cause], lateness)
        if self._held is None and (late := self.overdue()) is not None:
            self._held = ControlLost(LATE[late.cause], late)
        return self._held


class LeasedSession(RobotSession):
    """Passes everything on to the robot's session, commands only under a valid lease.

    Args:
        inner: the robot.
        lease: looked at before every command.
    """

    def __init__(self, inner: RobotSession, lease: Lease, sleep: Callable[[float], None] = time.sleep) -> None:
        self.inner = inner
        self.lease = lease
        self.period, self.late_s = inner.period, inner.late_s
        self._sleep = sleep
        self._states = 0  # since the last command

    def find_start(self) -> Array:
        """Where the robot stands, (n,), rad; needs no lease."""
        return self.inner.find_start()

    def __enter__(self) -> Self:
        self.inner.__enter__()
        self.lease.begin()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self.inner.__exit__(kind, error, traceback)

    def state(self) -> RobotState:
        """Waits for the next period and returns the robot's state at it; needs no lease."""
        self._states += 1
        return self.inner.state()

    def command(self, q: Array) -> None:
        """Sets the joint positions (n,) to be reached by the next period, rad, if the lease allows it.

        Raises:
            Held, Commanded, ControlLost: the lease does not allow it; the robot was stopped.
        """
        if self.lease.look():
            self._catch_up()
        refusal = self.lease.refusal()
        if refusal is not None:
            self.inner.stop()
            raise refusal
        self.inner.command(q)
        self._states = 0

    def _catch_up(self) -> None:
        """The loop got no time: neither did the thread that takes the renewals. The robot is not commanded while it does.

        Between two motions the loop may take its time to prepare the next one: the last state of a motion has no command, so that its
        successor's first command comes after two. A hold is a motion: it is commanded in every period.
        """
        if self._states != 1:
            self.lease.begin()
            self.lease.look()
        for _ in range(round(CATCH_UP_S / 0.001)):
            if self.lease.overdue() is None:
                return
            self._sleep(0.001)

    def complete(self, state: RobotState) -> RobotState:
        """As the robot's session completes it."""
        return self.inner.complete(state)

    def remarks(self) -> list[Message]:
        """Of the robot's session."""
        return self.inner.remarks()

    def stop(self) -> None:
        """Brakes the robot to standstill within its own limits; needs no lease."""
        self.inner.stop()

    def release(self) -> None:
        """Allows commands again after a stop, from the position the robot stands at. The next command needs a lease all the same."""
        self.inner.release()
        self.lease.begin()
