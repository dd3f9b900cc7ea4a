"""What a session needs of a force/torque sensor that has a line of its own."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from types import TracebackType
from typing import Self

from core.array import Array
from core.sensors.sequence import Tally
from core.words.message import Message


@dataclass(frozen=True)
class Reading:
    """One sample.

    Args:
        stamp_s: when it was taken, on the sensor's own clock, s; it neither wraps nor runs backwards, but for samples that were overtaken.
        arrival_s: when it arrived, monotonic clock of this machine, s.
        wrench: (6,), N and N m, the sensor's axes, in the sign and with the offsets of the sensor.
        temperature: degC, None where the sensor does not say.
        fault: why it is no measurement, in the sensor's own words; None where it is one.
    """

    stamp_s: float
    arrival_s: float
    wrench: Array
    temperature: float | None = None
    fault: Message | None = None


class ForceSensor(ABC):
    """Owns the line to the sensor from entry to exit. It neither zeroes nor filters: what is read is what the sensor sends."""

    name: str
    """For messages: make and place."""
    tally: Tally
    """What came of its samples since the entry."""

    range: Array | None = None
    """(6,), N and N m, from which it is saturated, from the entry on; None where it does not say."""

    @abstractmethod
    def __enter__(self) -> Self:
        """Checks that it is the sensor that was told, and starts its stream.

        Raises:
            NotConnected, UnusableSensor: it cannot be used.
        """

    @abstractmethod
    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        """Stops the stream and closes the line."""

    @abstractmethod
    def read(self, wait_s: float = 0.0) -> list[Reading]:
        """The samples that have arrived since, in the order of arrival, each once; waits for the first one for `wait_s` at most.

        Raises:
            BadState: the sensor began anew, or the line is gone.
        """

    def remarks(self) -> list[Message]:
        """What somebody should know of how it is set up, after the entry."""
        return []
