"""A monotonic clock that only the test moves."""

from __future__ import annotations


class HandClock:
    """`clock.now` is what it shows, s."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now
