"""How fast a session that is not bound to a real robot's clock goes."""

from __future__ import annotations

import time
from array import array
from collections.abc import Callable
from statistics import median
from typing import Protocol

LATE_S = 0.005
"""A sample that comes later than this was late."""
PAUSE_S = 0.25
"""Nobody asks for samples while a robot is held, or while its motion is planned anew: that is not made up for."""


class Pace(Protocol):
    """Decides when a sample may be handed out."""

    def wait_until(self, t: float) -> None:
        """Returns when the session's clock may show `t` seconds."""
        ...


class AsFastAsPossible:
    """Never waits."""

    def wait_until(self, t: float) -> None:
        """Returns at once."""


class RealTime:
    """Goes with the wall clock from the first sample on; what comes late is made up for, so that no error adds up, but for pauses.

    Args:
        speed: seconds of the session per second of the wall clock.
        clock, sleep: a monotonic clock, s, and what waits on it.
    """

    def __init__(
        self,
        speed: float = 1.0,
        *,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._speed = speed
        self._clock = clock
        self._sleep = sleep
        self._zero: float | None = None
        self._late_s = array("d")

    def wait_until(self, t: float) -> None:
        """Sleeps until the wall clock has come to `t`; counts how late it then is."""
        early = self._due(t) - self._clock()
        if early > 0:
            self._sleep(early)
        self._late_s.append(self._clock() - self._due(t))

    @property
    def ticks(self) -> int:
        """How often it was asked."""
        return len(self._late_s)

    @property
    def late(self) -> int:
        """How often it came more than `LATE_S` too late."""
        return sum(late_s > LATE_S for late_s in self._late_s)

    @property
    def latest_s(self) -> float:
        """How late it came at most, s."""
        return max(self._late_s, default=0.0)

    @property
    def median_s(self) -> float:
        """How late it came in the median, s."""
        return median(self._late_s) if self._late_s else 0.0

    def _due(self, t: float) -> float:
        """When the wall clock comes to `t`; after a pause it is now."""
        now = self._clock()
        if self._zero is None or now - self._zero - t / self._speed > PAUSE_S:
            self._zero = now - t / self._speed
        return self._zero + t / self._speed
