"""Answers a controller while nobody asks for states, so that it does not end the motion of a robot that stands."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

AWAY_S = 0.008
"""After this long without anybody, the controller is answered; it waits for 20 ms."""
LOOK_S = 0.002


class Keeper:
    """A thread that stands in for the control loop.

    Args:
        attend: answers the controller where the robot stands or brakes, and nothing else; called by this thread.
    """

    def __init__(self, attend: Callable[[], None]) -> None:
        self._attend, self._last = attend, time.monotonic()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._keep, name="Keeper", daemon=True)

    def begin(self) -> None:
        """From now on it looks."""
        self._thread.start()

    def note(self) -> None:
        """Somebody is there."""
        self._last = time.monotonic()

    @property
    def alone(self) -> bool:
        """Whether nobody has been there for too long."""
        return time.monotonic() - self._last > AWAY_S

    def end(self) -> None:
        """It looks no more."""
        self._ended.set()
        if self._thread.is_alive():
            self._thread.join()

    def _keep(self) -> None:
        while not self._ended.wait(LOOK_S):
            if self.alone:
                self._attend()
