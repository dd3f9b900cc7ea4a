"""A second opinion on a plan: every set point measured once more, with another library, other kinematics and finite differences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.second_opinion.arm import Frames, build_solid_arm
from core.second_opinion.least import find_least
from core.second_opinion.lost_load import nearest_flight
from core.second_opinion.pairs import AccountedPair, PairKind, Placed, classify_pairs, place_bodies, place_standing
from core.second_opinion.solids import PlacedSolid, distance

NUMERICAL_M = 1e-5
"""python-fcl now and then puts solids some micrometres nearer than they are."""
NUMERICAL = 1e-6
"""Relative, of speeds."""


class JointPath(NamedTuple):
    """A part of a motion: its name, and the joint positions q (N, n) that are commanded one period after the other, rad."""

    name: str
    q: Array


@dataclass(frozen=True)
class Approach:
    """Where a kind of pair comes closest to what it has to keep.

    Args:
        distance_m: signed, negative where they penetrate.
        part: name of the part of the motion.
        time_s: since the beginning of that part.
    """

    kind: PairKind
    first: str
    second: str
    distance_m: float
    required_m: float
    part: str
    time_s: float


@dataclass(frozen=True)
class PeakSpeed:
    """The fastest corner of a body, or of a box round it where that keeps the limit, over one period.

    Args:
        body: name of the link, or "payload".
        time_s: end of that period, since the beginning of the part.
    """

    speed_m_s: float
    limit_m_s: float
    body: str
    part: str
    time_s: float


@dataclass(frozen=True)
class LostLoad:
    """The flight of a load that comes off on the way which comes nearest to a protected zone.

    Args:
        distance_m: signed, negative where it gets into the zone.
        speed_m_s: of the fastest point as it comes off.
        time_s: when it comes off, since the beginning of the part.
    """

    zone: str
    distance_m: float
    speed_m_s: float
    part: str
    time_s: float


@dataclass(frozen=True)
class Opinion:
    """What the second opinion found.

    Args:
        approaches: one for each kind of which there are pairs and something is asked.
        pairs: all pairs, with what is asked of each and why.
        lost_load: None where there is no protected zone.
    """

    approaches: tuple[Approach, ...]
    fastest: PeakSpeed
    pairs: tuple[AccountedPair, ...]
    samples: int
    lost_load: LostLoad | None = None

    @property
    def violations(self) -> tuple[Approach | PeakSpeed | LostLoad, ...]:
        """What does not keep the cell's limits, distances first, then where a lost load flies."""
        close = [each for each in self.approaches if each.distance_m < each.required_m - NUMERICAL_M]
        fast = [self.fastest] if self.fastest.speed_m_s > self.fastest.limit_m_s * (1.0 + NUMERICAL) else []
        lost = [self.lost_load] if self.lost_load is not None and self.lost_load.distance_m < 0.0 else []
        return (*close, *lost, *fast)

    @property
    def nearest_thing(self) -> Approach | None:
        """Where anything that moves comes closest to an obstacle or a zone, the first link included; None where there is neither."""
        around = [each for each in self.approaches if each.kind in (PairKind.ENVIRONMENT, PairKind.FIRST_LINK, PairKind.MOUNT)]
        return min(around, key=lambda each: each.distance_m, default=None)

    @property
    def left_out(self) -> tuple[AccountedPair, ...]:
        """The pairs of links, payload and tools of which nothing is asked, each once."""
        judged = {(pair.first, pair.second) for pair in self.pairs if pair.kind.is_judged}
        others = {(pair.first, pair.second): pair for pair in self.pairs if pair.first != pair.second}
        return tuple(pair for names, pair in others.items() if names not in judged)

    @property
    def passes(self) -> bool:
        """Whether every limit is kept."""
        return not self.violations


class _Times(NamedTuple):
    """From the samples of a whole motion to its parts."""

    names: list[str]
    starts: Array
    period: float

    def of(self, sample: int) -> tuple[str, float]:
        """Name of the part, and time since its beginning, s."""
        k = int(np.searchsorted(self.starts, sample, side="right")) - 1
        return self.names[k], float(self.period * (sample - self.starts[k]))


def second_opinion(cell: Cell, payload_box: Box, paths: Sequence[JointPath], period: float) -> Opinion:
    """Judges the parts of a motion, which follow each other without a step.

    Args:
        payload_box: sensor frame.
        period: between samples, s.

    Raises:
        BadRobot: the second opinion cannot read one of the arm's meshes.
        ValueError: a set point is not finite.
    """
    arm = build_solid_arm(cell, payload_box)
    q = np.concatenate([path.q for path in paths])
    if not np.isfinite(q).all():
        raise ValueError("a set point of the plan is not finite")
    times = _Times([path.name for path in paths], np.cumsum([0, *(len(path.q) for path in paths[:-1])]), period)
    pairs = classify_pairs(cell, arm)
    bodies = [*place_bodies(arm, q), *place_standing(cell)]
    steps = [_steps(body.frames, body.solid.corners) for body in bodies]
    alone = [_way(step, len(q)) for step in steps]
    kinds = [kind for kind in PairKind if kind != PairKind.JOINED and any(pair.kind == kind for pair in pairs)]
    at = cache(lambda body, sample: bodies[body].at(sample))
    approaches = []
    for kind in kinds:
        these = [pair for pair in pairs if pair.kind == kind]
        ways = [_way_between(bodies, pair) if kind.is_close else alone[pair.bodies[0]] + alone[pair.bodies[1]] for pair in these]
        approaches.append(_approach(kind, these, at, ways, times))
    fastest = _fastest(bodies, steps, times, cell.limits.cartesian_speed_m_s)
    flight = nearest_flight(cell, payload_box, arm.sensor_frames(q), period)
    lost = None if flight is None else LostLoad(flight.zone, flight.distance_m, flight.speed_m_s, *times.of(flight.sample))
    return Opinion(tuple(approaches), fastest, tuple(pairs), len(q), lost)


def _steps(frames: Frames, corners: Array) -> Array:
    """(N - 1,), how far the farthest of a body's corners (k, 3) moves in each period, m."""
    rotation, position = np.diff(frames.rotation, axis=0), np.diff(frames.position, axis=0)
    squared = np.zeros(len(position))
    for corner in corners:
        moved = rotation @ corner + position
        squared = np.maximum(squared, np.einsum("ni,ni->n", moved, moved))
    return np.sqrt(squared)


def _way(steps: Array, samples: int) -> Array:
    """(samples,), the sum of the steps so far; of what stands, nothing."""
    return np.concatenate(([0.0], np.cumsum(steps))) if len(steps) else np.zeros(samples)


def _way_between(bodies: list[Placed], pair: AccountedPair) -> Array:
    """(N,), how far the first body of a pair has moved as seen from the second."""
    first, second = (bodies[k] for k in pair.bodies)
    return _way(_steps(first.frames.express_in(second.frames), first.solid.corners), len(first.frames.position))


def _approach(
    kind: PairKind, pairs: list[AccountedPair], at: Callable[[int, int], PlacedSolid], ways: list[Array], times: _Times
) -> Approach:
    """Where the pairs of a kind come closest to what they have to keep.

    Args:
        at: where a body, by its number, is at a sample.
        ways: of each pair (N,), m, a rising length: its margin changes between two samples by no more than that rises.
    """

    def margin(k: int, sample: int) -> float:
        first, second = pairs[k].bodies
        return distance(at(first, sample), at(second, sample)) - pairs[k].required_m

    least = find_least(ways, margin, [pair.resolution_m for pair in pairs])
    pair = pairs[least.pair]
    return Approach(kind, pair.first, pair.second, least.margin + pair.required_m, pair.required_m, *times.of(least.sample))


def _fastest(bodies: list[Placed], steps: list[Array], times: _Times, limit: float) -> PeakSpeed:
    moving = [(body, _exact(body, step, limit * times.period)) for body, step in zip(bodies, steps, strict=True) if len(step)]
    fastest = [(float(step.max()), int(step.argmax()), body.name) for body, step in moving]
    moved, sample, name = max(fastest, default=(0.0, -1, bodies[0].name))
    return PeakSpeed(moved / times.period, limit, name, *times.of(sample + 1))


def _exact(body: Placed, steps: Array, allowed: float) -> Array:
    """The steps of a body's box, those of its own corners in place of those that are longer than allowed: a box round a mesh is larger."""
    rows = np.flatnonzero(steps > allowed)
    if not len(rows) or body.solid.radius_m > 0.0:
        return steps
    ends = np.unique(np.concatenate([rows, rows + 1]))
    frames = Frames(body.frames.rotation[ends], body.frames.position[ends])
    exact = steps.copy()
    exact[rows] = _steps(frames, body.solid.points)[np.searchsorted(ends, rows)]
    return exact
