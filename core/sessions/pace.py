"""How fast a session that is not bound to a real robot's clock goes."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Protocol


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
    """Goes with the wall clock from the first sample on; what comes late is made up for, so that no error adds up.

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

    def wait_until(self, t: float) -> None:
        """Sleeps until the wall clock has come to `t`."""
        now = self._clock()
        if self._zero is None:
            self._zero = now - t / self._speed
        late = now - self._zero - t / self._speed
        if late < 0:
            self._sleep(-late)
