"""Certified distances along a motion: no violation between samples.

The margin of a pair of bodies cannot change by more than one moves relative to the other. With margins m_a and m_b at the ends of an
interval over which that is at most b, the margin inside is at least (m_a + m_b - b) / 2; an interval for which that does not suffice is
halved.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from heapq import heappop, heappush

import numpy as np

from core.array import Array
from core.planning.pair_margins import PairMargins

Spare = Callable[[Array], float]
"""Margin (m) that a planner wants to keep at a configuration on top of what the cell requires."""

SMALLEST_M = 2e-5
"""An interval in which nothing moves more than this and that is still not certified counts as a violation."""


@dataclass(frozen=True)
class LeastMargin:
    """The smallest margin along a motion.

    Args:
        margin_m: smallest margin that was sampled.
        bound_m: certified: nowhere along the motion is the margin smaller than this.
        q: (n,), where `margin_m` was met.
    """

    margin_m: float
    bound_m: float
    q: Array


class Swept:
    """A polyline in joint space with the margins of all pairs along it; the parameter is the row number.

    Args:
        q: (N, n), rad.
    """

    def __init__(self, margins: PairMargins, q: Array) -> None:
        self._margins = margins
        self._q = np.asarray(q, dtype=float)
        self._moved = np.concatenate(
            (np.zeros((1, len(margins.reach))), np.cumsum(np.abs(np.diff(self._q, axis=0)) @ margins.reach.T, axis=0))
        )

    def sample(self, at: float) -> MarginSample:
        """Configuration, margins and way so far at the parameter."""
        i = min(int(at), max(len(self._q) - 2, 0))
        j = min(i + 1, len(self._q) - 1)
        q = self._q[i] + (at - i) * (self._q[j] - self._q[i])
        moved = self._moved[i] + (at - i) * (self._moved[j] - self._moved[i])
        margins = self._margins(q)
        return MarginSample(at, q, margins, moved, float(margins.min(initial=np.inf)))

    def ends(self) -> tuple[MarginSample, MarginSample]:
        """First and last sample."""
        return self.sample(0.0), self.sample(float(len(self._q) - 1))


@dataclass(frozen=True, order=True)
class MarginSample:
    """One configuration of a swept polyline: margins (n_pairs,), and how far each pair has moved at most since the start, m."""

    at: float
    q: Array = field(compare=False)
    margins: Array = field(compare=False)
    moved: Array = field(compare=False)
    margin_m: float = field(compare=False)


def is_clear(margins: PairMargins, q: Array, spare: Spare | float = 0.0) -> bool:
    """Whether the polyline q (N, n) keeps every required distance everywhere, and `spare` more at the samples that are looked at.

    Of pairs whose construction leaves them little room a part of `spare` is asked.
    """
    swept = Swept(margins, q)

    def is_enough(sample: MarginSample) -> bool:
        asked = spare(sample.q) if callable(spare) else spare
        return sample.margin_m >= 0.0 and bool((sample.margins >= asked * margins.share).all())

    first, last = swept.ends()
    if not (is_enough(first) and is_enough(last)):
        return False
    intervals = deque([(first, last)])
    while intervals:
        a, b = intervals.popleft()  # breadth first: a collision in the middle is found early
        if _bound(a, b) >= 0.0:
            continue
        if (b.moved - a.moved).max() <= SMALLEST_M:
            return False
        middle = swept.sample(0.5 * (a.at + b.at))
        if not is_enough(middle):
            return False
        intervals.append((a, middle))
        intervals.append((middle, b))
    return True


def least_margin(margins: PairMargins, q: Array, *, tolerance_m: float = 0.001) -> LeastMargin:
    """The smallest margin along the polyline q (N, n), by branch and bound; the search ends early where it is negative.

    Args:
        tolerance_m: largest difference between what was sampled and what is certified; finer where the margin is smaller than that.
    """
    swept = Swept(margins, q)
    a, b = swept.ends()
    least = min(a, b, key=_margin_of)
    intervals = [(_bound(a, b), a, b)]
    while True:
        bound, a, b = intervals[0]
        enough = bound >= least.margin_m - min(tolerance_m, max(least.margin_m, 0.0))
        if least.margin_m < 0.0 or enough or (b.moved - a.moved).max() <= SMALLEST_M:
            return LeastMargin(least.margin_m, min(bound, least.margin_m), least.q)
        heappop(intervals)
        middle = swept.sample(0.5 * (a.at + b.at))
        least = min(least, middle, key=_margin_of)
        heappush(intervals, (_bound(a, middle), a, middle))
        heappush(intervals, (_bound(middle, b), middle, b))


def _bound(a: MarginSample, b: MarginSample) -> float:
    """Certified smallest margin between two samples."""
    return 0.5 * float((a.margins + b.margins - (b.moved - a.moved)).min(initial=np.inf))


def _margin_of(sample: MarginSample) -> float:
    return sample.margin_m
