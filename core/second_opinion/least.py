"""The least of many margins along a path, as if every sample had been looked at.

No point of a body moves farther from one sample to the next than the farthest corner of a box round it, and no signed distance changes by
more than its two bodies move. Between two samples a margin can therefore not be below half of (their margins - the way in between), and
most samples need not be looked at.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from core.array import Array


class Least(NamedTuple):
    """The least margin, m, of which pair, at which sample."""

    margin: float
    pair: int
    sample: int


def find_least(ways: Sequence[Array], margin: Callable[[int, int], float], resolutions: Sequence[float]) -> Least:
    """The least of `margin(pair, sample)` over all pairs and samples.

    Args:
        ways: for each pair (N,), a rising length: no margin changes between two samples by more than it rises.
        resolutions: of each pair; a margin of it that is less than this below the one returned may be overlooked, unless it is negative and
            that one is not.
    """
    best = Least(np.inf, -1, -1)
    stretches: list[tuple[float, int, int, int, float, float]] = []

    def look(pair: int, sample: int) -> float:
        nonlocal best
        found = margin(pair, sample)
        best = min(best, Least(found, pair, sample))
        return found

    def matters(bound: float, pair: int) -> bool:
        return bound < best.margin - resolutions[pair] or bound < 0.0 <= best.margin

    def keep(pair: int, i: int, k: int, at_i: float, at_k: float) -> None:
        bound = 0.5 * (at_i + at_k - (ways[pair][k] - ways[pair][i]))
        if k - i > 1 and matters(bound, pair):
            heapq.heappush(stretches, (bound, pair, i, k, at_i, at_k))

    for pair, way in enumerate(ways):
        last = len(way) - 1
        keep(pair, 0, last, look(pair, 0), look(pair, last))
    while stretches:
        bound, pair, i, k, at_i, at_k = heapq.heappop(stretches)
        if bound >= best.margin:  # so are all that follow
            break
        if not matters(bound, pair):
            continue
        middle = (i + k) // 2
        at_middle = look(pair, middle)
        keep(pair, i, middle, at_i, at_middle)
        keep(pair, middle, k, at_middle, at_k)
    return best
