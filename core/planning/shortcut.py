"""Shortens a path in time: what counts is how long the Cartesian and joint speed limits make it, not its length in joint space.

Random shortcuts, of all joints or of one alone (Geraerts and Overmars 2007, "Creating high-quality paths for motion planning"), and random
displacements of corners; each is kept when it saves time and is clear.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from core.array import Array

Cost = Callable[[Array], float]
Clear = Callable[[Array], bool]

_CORNER_COST = 0.02
"""s; keeps the number of corners small."""


def shorten_path(q: Array, cost: Cost, is_clear: Clear, rng: np.random.Generator, *, attempts: int) -> Array:
    """A polyline (M, n) between the same ends that costs no more than q (N, n).

    Args:
        cost: time that a polyline takes, s.
        is_clear: whether a polyline keeps all distances; `q` is taken to be clear.
        attempts: number of changes that are tried.
    """
    best = np.array(q, dtype=float)
    total = _price(best, cost)
    moves = (_straighten, _straighten_joint, _displace_corner)
    for _ in range(attempts):
        move = moves[rng.integers(len(moves))]
        candidate = move(best, rng)
        if candidate is None:
            continue
        price = _price(candidate.whole, cost)
        if price < 0.999 * total and is_clear(candidate.changed):
            best, total = candidate.whole, price
    return best


class _Candidate:
    """A changed polyline, and the part of it that is new."""

    def __init__(self, before: Array, changed: Array, after: Array) -> None:
        self.changed = changed
        self.whole = np.concatenate((before, changed, after))


def _price(q: Array, cost: Cost) -> float:
    return cost(q) + _CORNER_COST * len(q)


def _two_places(q: Array, rng: np.random.Generator) -> tuple[int, Array, int, Array]:
    """Two random points of the polyline: index of the side and position, in order."""
    length = np.linalg.norm(np.diff(q, axis=0), axis=1)
    at = np.sort(rng.uniform(0.0, length.sum(), 2))
    ends = np.cumsum(length)
    i, j = (int(min(k, len(length) - 1)) for k in np.searchsorted(ends, at))
    points = [q[k] + (a - ends[k] + length[k]) / length[k] * (q[k + 1] - q[k]) for k, a in zip((i, j), at, strict=True)]
    return i, points[0], j, points[1]


def _straighten(q: Array, rng: np.random.Generator) -> _Candidate | None:
    """The straight line between two points; half of the time they are corners."""
    if len(q) < 3:
        return None
    if rng.random() < 0.5:
        i, j = np.sort(rng.choice(len(q), 2, replace=False))
        return _Candidate(q[:i], q[[i, j]], q[j + 1 :]) if j - i > 1 else None
    i, first, j, last = _two_places(q, rng)
    return _Candidate(q[: i + 1], np.stack((first, last)), q[j + 1 :]) if j > i else None


def _straighten_joint(q: Array, rng: np.random.Generator) -> _Candidate | None:
    """One joint on the straight line between two points, the others as they were."""
    i, first, j, last = _two_places(q, rng)
    if j == i:
        return None
    changed = np.concatenate((first[None], q[i + 1 : j + 1], last[None]))
    along = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(changed, axis=0), axis=1))))
    if along[-1] < 1e-6:
        return None
    joint = rng.integers(q.shape[1])
    changed[:, joint] = first[joint] + along / along[-1] * (last[joint] - first[joint])
    return _Candidate(q[: i + 1], changed, q[j + 1 :])


def _displace_corner(q: Array, rng: np.random.Generator) -> _Candidate | None:
    """One corner, or a new one, moved at random."""
    size = 0.5 * 10.0 ** rng.uniform(-1.5, 0.0)
    if len(q) > 2 and rng.random() < 0.7:
        i = int(rng.integers(1, len(q) - 1))
        corner, before, after = q[i], i - 1, i + 1
    else:
        before, corner, _, _ = _two_places(q, rng)
        after = before + 1
    moved = corner + rng.normal(0.0, size, q.shape[1]) * (rng.random(q.shape[1]) < 0.5)
    return _Candidate(q[:before], np.stack((q[before], moved, q[after])), q[after + 1 :])
