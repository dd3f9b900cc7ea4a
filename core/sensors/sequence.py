"""Counts samples by a number that wraps around: what was lost, came twice, or came out of order."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from enum import Enum

LOOK_BACK = 4096
"""A number that is farther behind than this is none of a packet that was overtaken: the sensor began to count anew."""


class Arrival(Enum):
    """What a sample's number says of it."""

    NEXT = "next"
    """The newest so far, whether or not numbers before it are missing."""
    OVERTAKEN = "overtaken"
    """It was missing, and comes after a newer one."""
    REPEATED = "repeated"
    """It was there before."""
    ANEW = "anew"
    """The sensor counts from the beginning."""


@dataclass
class Tally:
    """What came of a sensor's samples, since the entry."""

    received: int = 0
    """Different samples."""
    lost: int = 0
    """Numbers that have not come, so far."""
    repeated: int = 0
    overtaken: int = 0
    malformed: int = 0
    """Packets or frames that are none: wrong length, check sum or sender."""

    @property
    def lost_share(self) -> float:
        """Of all that were sent."""
        sent = self.received + self.lost
        return self.lost / sent if sent else 0.0


class Sequence:
    """Unwraps the numbers of samples.

    Args:
        modulus: the number after the last one is 0.
        tally: what is counted.
    """

    def __init__(self, modulus: int, tally: Tally) -> None:
        self._modulus, self._tally = modulus, tally
        self._newest: int | None = None
        self._first = 0
        self._recent: deque[int] = deque(maxlen=LOOK_BACK)
        self._seen: set[int] = set()

    def place(self, number: int) -> tuple[Arrival, int]:
        """What it is, and the number without wrap: it goes on beyond the modulus."""
        if self._newest is None:
            self._first = number
            return self._take(Arrival.NEXT, number)
        ahead = (number - self._newest) % self._modulus
        if ahead == 0:
            self._tally.repeated += 1
            return Arrival.REPEATED, self._newest
        if ahead < self._modulus // 2:
            self._tally.lost += ahead - 1
            return self._take(Arrival.NEXT, self._newest + ahead)
        behind = self._modulus - ahead
        if behind > LOOK_BACK:
            return Arrival.ANEW, number
        whole = self._newest - behind
        if whole in self._seen:
            self._tally.repeated += 1
            return Arrival.REPEATED, whole
        self._tally.overtaken += 1
        if whole < self._first:
            self._tally.lost += self._first - whole - 1
            self._first = whole
        else:
            self._tally.lost -= 1
        return self._take(Arrival.OVERTAKEN, whole)

    def _take(self, arrival: Arrival, whole: int) -> tuple[Arrival, int]:
        if len(self._recent) == self._recent.maxlen:
            self._seen.discard(self._recent[0])
        self._recent.append(whole)
        self._seen.add(whole)
        self._newest = whole if self._newest is None else max(self._newest, whole)
        self._tally.received += 1
        return arrival, whole
