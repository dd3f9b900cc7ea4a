"""A session that obeys only while somebody is in control of the robot.

The lease is renewed by whoever answers for the motion (a person at the cell, through the server). It is checked at every command, where
commands reach the robot: nothing that fails upstream, an event loop, a pipe or a thread, can keep the robot moving.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

from core.errors import Commanded, ControlLost, Held, Stopped
from core.sessions.session import RobotSession, RobotState

Array = NDArray[np.float64]

LEASE_S = 0.22
"""How long one renewal lasts; with the reaction of the loop the commanded motion ends well within 300 ms of the last one."""
FUTURE_S = 0.005
"""Stamps may be ahead of our clock by this much: clocks are read a moment apart. One from the future would not go stale."""


@dataclass(frozen=True)
class Renewal:
    """One sign of life.

    Args:
        fence: counts the holders of control; who holds an older one has lost it.
        number: counts the renewals of one fence.
        stamp_s: when it was given, `time.monotonic()` of this machine.
    """

    fence: int
    number: int
    stamp_s: float


class Lease:
    """Who may command the robot, and until when. One thread writes, the control loop reads: every attribute is set in one step.

    Args:
        length_s: how long one renewal lasts.
        clock: monotonic, the one that stamps the renewals, s.
    """

    def __init__(self, length_s: float = LEASE_S, clock: Callable[[], float] = time.monotonic) -> None:
        self.length_s = length_s
        self._clock = clock
        self._last = Renewal(fence=-1, number=-1, stamp_s=-np.inf)
        self._held = False
        self._ended: str | None = None

    def renew(self, renewal: Renewal) -> bool:
        """Takes a sign of life; one that is old, repeated, out of order or from the future counts for nothing (False)."""
        now, last = self._clock(), self._last
        newer = (renewal.fence, renewal.number) > (last.fence, last.number) and renewal.stamp_s > last.stamp_s
        if not newer or not now - self.length_s < renewal.stamp_s <= now + FUTURE_S:
            return False
        self._last = renewal
        return True

    def hold(self) -> None:
        """The robot is to pause."""
        self._held = True

    def resume(self) -> None:
        """It may go on."""
        self._held = False

    def end(self, reason: str) -> None:
        """The robot is to stop for good; `reason` is a sentence."""
        self._ended = reason

    @property
    def fence(self) -> int:
        """Of the present holder."""
        return self._last.fence

    @property
    def age_s(self) -> float:
        """Time since the last renewal, s."""
        return self._clock() - self._last.stamp_s

    def refusal(self) -> Stopped | None:
        """Why the robot may not be commanded now; None if it may."""
        if self._ended is not None:
            return Commanded(self._ended, value=1.0, limit=0.0)
        age = self.age_s
        if age > self.length_s:
            return ControlLost(
                f"nobody has been in control of the robot for {1e3 * age:.0f} ms (limit {1e3 * self.length_s:.0f} ms); the robot was "
                "stopped. Take control and release a new run.",
                value=age,
                limit=self.length_s,
            )
        if self._held:
            return Held("the robot was asked to pause; it stands until it is told to go on.", value=1.0, limit=0.0)
        return None


class LeasedSession(RobotSession):
    """Passes everything on to the robot's session, commands only under a valid lease.

    Args:
        inner: the robot.
        lease: looked at before every command.
    """

    def __init__(self, inner: RobotSession, lease: Lease) -> None:
        self.inner = inner
        self.lease = lease
        self.period = inner.period

    def __enter__(self) -> Self:
        self.inner.__enter__()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self.inner.__exit__(kind, error, traceback)

    def state(self) -> RobotState:
        """See `RobotSession.state`."""
        return self.inner.state()

    def command(self, q: Array) -> None:
        """See `RobotSession.command`.

        Raises:
            Held, Commanded, ControlLost: the lease does not allow it; the robot was stopped.
        """
        refusal = self.lease.refusal()
        if refusal is not None:
            self.inner.stop()
            raise refusal
        self.inner.command(q)

    def stop(self) -> None:
        """See `RobotSession.stop`; needs no lease."""
        self.inner.stop()

    def release(self) -> None:
        """See `RobotSession.release`. The next command needs a lease all the same."""
        self.inner.release()
