"""A sensor that is read by a thread of its own, so that no sample is late or lost because the control loop was elsewhere."""

from __future__ import annotations

from collections import deque
from threading import Event, Thread
from types import TracebackType
from typing import Self

from core.errors import HeftError
from core.sensors.sensor import ForceSensor, Reading
from core.words.message import Message

WAIT_S = 0.05
"""How long the thread waits for a sample before it looks whether it is to end."""
MOST = 100_000
"""Readings that wait to be taken; the oldest are dropped."""


class BackgroundSensor(ForceSensor):
    """Passes on what the sensor reads; what stops it is raised at the next `read`.

    Args:
        inner: the sensor, entered and left with this one.
    """

    def __init__(self, inner: ForceSensor) -> None:
        self.inner = inner
        self.name, self.tally = inner.name, inner.tally
        self._waiting: deque[Reading] = deque(maxlen=MOST)
        self._arrived, self._end = Event(), Event()
        self._error: HeftError | OSError | None = None
        self._thread: Thread | None = None

    def __enter__(self) -> Self:
        self.inner.__enter__()
        self.tally, self.range = self.inner.tally, self.inner.range
        self._end.clear()
        self._waiting.clear()
        self._error = None
        self._thread = Thread(target=self._run, name="sensor", daemon=True)
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._end.set()
        if self._thread is not None:
            self._thread.join()
        self.inner.__exit__(kind, error, traceback)

    def read(self, wait_s: float = 0.0) -> list[Reading]:
        """What has arrived since the last call."""
        if wait_s > 0.0 and not self._waiting and self._error is None:
            self._arrived.wait(wait_s)
        self._arrived.clear()
        found = [self._waiting.popleft() for _ in range(len(self._waiting))]
        if self._error is not None and not found:
            raise self._error
        return found

    def remarks(self) -> list[Message]:
        """Of the sensor."""
        return self.inner.remarks()

    def _run(self) -> None:
        try:
            while not self._end.is_set():
                self._waiting.extend(self.inner.read(WAIT_S))
                self._arrived.set()
        except (HeftError, OSError) as error:
            self._error = error
            self._arrived.set()
