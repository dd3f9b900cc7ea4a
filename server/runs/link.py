"""The connection to the console that is in control: how long its answers take, as the stamps that keep the lease measure it."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import numpy as np

WINDOW_S = 60.0
"""Of what is judged."""
FEWEST = 20
"""Answers before anything is said."""
ADVISED_SHARE = 0.75
"""Of the lease that may pass between two answers; over a link that comes nearer to the lease a run is likely to be put on hold."""


class LinkFigures(NamedTuple):
    """Of the last `WINDOW_S`.

    Args:
        lost_share: of the stamps, those not answered within the lease.
        longest_gap_s: the longest time that control rested on one answer.
        advised: whether a release over this link is advisable.
    """

    round_trip_p50_s: float
    round_trip_p99_s: float
    lost_share: float
    longest_gap_s: float
    answers: int
    window_s: float
    advised: bool


class Link:
    """Of one holder of control. Times are the server's, monotonic, s."""

    def __init__(self) -> None:
        self._answers: deque[tuple[float, float, float]] = deque()  # arrival, round trip, gap before it
        self._sent: deque[float] = deque()
        self._stamp_s: float | None = None

    def note_stamp(self, stamp_s: float) -> None:
        """A stamp has left."""
        self._sent.append(stamp_s)

    def note_answer(self, stamp_s: float, now_s: float) -> None:
        """An answer to a stamp has come."""
        gap = 0.0 if self._stamp_s is None else now_s - self._stamp_s
        self._answers.append((now_s, now_s - stamp_s, gap))
        self._stamp_s = max(stamp_s, stamp_s if self._stamp_s is None else self._stamp_s)
        while self._answers[0][0] < now_s - WINDOW_S:
            self._answers.popleft()
        while self._sent and self._sent[0] < now_s - WINDOW_S:
            self._sent.popleft()

    def figures(self, lease_s: float, now_s: float) -> LinkFigures | None:
        """What they were like; None while there are too few answers."""
        if len(self._answers) < FEWEST or self._stamp_s is None:
            return None
        arrivals, round_trips, gaps = np.array(self._answers).T
        due = sum(stamp < now_s - lease_s for stamp in self._sent)
        in_time = int(((arrivals - round_trips < now_s - lease_s) & (round_trips <= lease_s)).sum())
        longest = max(float(gaps.max()), now_s - self._stamp_s)
        lost = max(0.0, 1.0 - in_time / due) if due else 0.0
        p50, p99 = np.quantile(round_trips, [0.5, 0.99])
        advised = bool(longest <= ADVISED_SHARE * lease_s)
        return LinkFigures(float(p50), float(p99), lost, longest, len(gaps), float(now_s - arrivals[0]), advised)
