"""What the arm does: ways between places in the space of its joints, with stops, without, or joint by joint, and wobbles at some."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any, Literal, NamedTuple

import numpy as np
from scipy.interpolate import make_interp_spline

from bench.second_stranger.arms import Arm
from bench.second_stranger.array import Array
from bench.second_stranger.motions import Stretch
from bench.second_stranger.signals import rise
from bench.third_stranger.places import Places

Tour = Literal["tour", "brisk", "snappy", "slow", "cycle", "rounds", "jog", "chirp", "flow", "poses"]
RISE_PEAK = 1.875
"""Greatest slope of `rise`."""
PLACES_OF_ROUND: dict[Tour, int] = {"cycle": 6, "rounds": 3}
"""By tours that come by the same places again and again: how many these are."""
ROOM: dict[Tour, float] = {"flow": 0.7, "chirp": 0.88}
"""By tours that go beyond their places: which share of the joints' range these keep to."""
SNAP_S = 0.07
"""In which a snappy way is at its speed."""


class Pace(NamedTuple):
    """Greatest speed, rad/s, of the joint that turns most; how long stops last, s; and the least that a way takes, s."""

    speeds: tuple[float, float]
    stops_s: tuple[float, float]
    least_s: float


PACES: dict[Tour, Pace] = {
    "tour": Pace((0.7, 1.3), (0.8, 2.2), 0.8),
    "brisk": Pace((2.0, 3.0), (0.5, 1.2), 0.5),
    "snappy": Pace((0.8, 1.2), (0.6, 1.4), 0.5),
    "slow": Pace((0.4, 0.7), (1.6, 3.2), 2.4),
    "cycle": Pace((0.9, 1.5), (0.7, 1.4), 0.7),
    "rounds": Pace((0.6, 0.75), (0.8, 1.5), 1.2),
    "jog": Pace((0.5, 1.1), (0.4, 1.8), 0.6),
    "chirp": Pace((0.8, 1.2), (1.0, 2.0), 0.8),
    "flow": Pace((0.6, 1.1), (1.5, 2.5), 0.9),
    "poses": Pace((0.8, 1.2), (1.4, 1.8), 1.0),
}


class _Course:
    """Stretches as they are put one behind the other."""

    def __init__(self, rng: np.random.Generator, places: Places, kind: Tour) -> None:
        self.rng, self.places, self.pace = rng, places, PACES[kind]
        self.is_snappy = kind == "snappy"
        self.stretches: list[Stretch] = []
        self.end_s = 0.0
        self.q = places.draw(None)

    def hold(self, label: str | None = None, seconds: float | None = None) -> None:
        """Where the arm is."""
        q = self.q
        lasting = seconds or self.rng.uniform(*self.pace.stops_s)
        self.append(lasting, label or self.places.label_hold(q), lambda t: np.tile(q, (len(t), 1)))

    def go(self, to: Array, label: str = "transfer") -> None:
        """Straight to joints (n,), rad, with a jerk that is as small as it can be, or at one speed in between where all is snappy."""
        start, begin_s = self.q, self.end_s
        speed = self.rng.uniform(*self.pace.speeds)
        if self.is_snappy:
            cruise_s = max(self.pace.least_s, float(np.max(np.abs(to - start))) / speed)
            self.append(cruise_s + SNAP_S, label, lambda t: start + _start_and_stop(t - begin_s, cruise_s)[:, None] * (to - start))
            self.q = to
            return
        seconds = max(self.pace.least_s, float(np.max(np.abs(to - start))) * RISE_PEAK / speed)
        self.append(seconds, label, lambda t: start + rise((t - begin_s) / seconds)[:, None] * (to - start))
        self.q = to

    def append(self, seconds: float, label: str, follow: Callable[[Array], Array]) -> None:
        """A stretch that follows joints (N, n), rad, at times (N,), s."""
        self.stretches.append(Stretch(self.end_s, self.end_s + seconds, label, follow))
        self.end_s += seconds


def _start_and_stop(t: Array, cruise_s: float) -> Array:
    """(N,), from 0 to 1 at times (N,), s: up to one speed, and down from it after so many s."""

    def run(x: Array) -> Array:
        within = np.clip(x, 0, 1)
        return np.asarray(within**3 - within**4 / 2 + np.maximum(x - 1, 0))

    return (run(t / SNAP_S) - run((t - cruise_s) / SNAP_S)) * SNAP_S / cruise_s


def draw_tour(rng: np.random.Generator, arm: Arm, up: Array, kind: Tour, seconds: float, pauses: int, is_moved: bool) -> list[Stretch]:
    """Stretches that take about so long, those called `pause` being what the recorder leaves out.

    Args:
        up: (3,), base axes, against gravity.
        is_moved: whether the arm goes elsewhere in each pause.
    """
    course = _Course(rng, Places(arm, rng, up, ROOM.get(kind, 1.0)), kind)
    steps = {"jog": _jog, "chirp": _chirp, "flow": _flow}
    step = steps.get(kind, _visit)
    rounds = [course.q, *(course.places.draw(course.q) for _ in range(PLACES_OF_ROUND.get(kind, 1) - 1))]
    course.hold(seconds=2.5)
    made = 0
    place = 0
    while course.end_s < seconds - 4:
        place += 1
        if kind in PLACES_OF_ROUND:
            course.go(rounds[place % len(rounds)] + np.radians(0.02) * rng.normal(size=arm.joint_count))
            course.hold()
        else:
            step(course)
        if made < pauses and course.end_s > seconds * (made + 1) / (pauses + 1):
            made += 1
            _pause(course, is_moved)
    course.hold(seconds=2.0)
    return course.stretches


def draw_poses(rng: np.random.Generator, arm: Arm, up: Array, count: int) -> list[Stretch]:
    """Stretches with so many stops, all in different attitudes."""
    course = _Course(rng, Places(arm, rng, up), "poses")
    for _ in range(count):
        course.go(course.places.draw(course.q))
        course.hold()
    return course.stretches


def _visit(course: _Course) -> None:
    """Goes to another place and stops there."""
    course.go(course.places.draw(course.q))
    course.hold()


def _pause(course: _Course, is_moved: bool) -> None:
    """The recorder stops for several seconds."""
    course.hold("pause", course.rng.uniform(2.5, 4.5))
    if is_moved:
        course.go(course.places.draw(course.q), "pause")
    course.hold("pause", course.rng.uniform(1.0, 3.0))
    course.hold(seconds=2.0)


def _jog(course: _Course) -> None:
    """By the teach pendant: one joint after another, in any order, to a place that is far enough."""
    to = course.places.draw(course.q)
    for joint in course.rng.permutation(len(to)).tolist():
        if abs(to[joint] - course.q[joint]) > np.radians(6):
            q = course.q.copy()
            q[joint] = to[joint]
            course.go(q)
            course.hold()


def _chirp(course: _Course) -> None:
    """Goes to another place and wobbles there with the joints of the wrist, faster and faster."""
    _visit(course)
    rng, q, begin_s = course.rng, course.q, course.end_s
    seconds, low, high = rng.uniform(6, 9), rng.uniform(0.15, 0.3), rng.uniform(0.9, 1.5)
    amplitudes = np.zeros(len(q))
    amplitudes[2:] = rng.uniform(0.1, 0.28, len(q) - 2) * rng.choice([-1, 1], len(q) - 2)
    shares = rng.uniform(0.8, 1.25, len(q))

    def wobble(t: Array) -> Array:
        x = t - begin_s
        turned = low * x + (high - low) * x * x / (2 * seconds)
        envelope = rise(x / 1.0) * rise((seconds - x) / 1.0) / (1 + 0.9 * turned / seconds)
        return np.asarray(q + envelope[:, None] * amplitudes * np.sin(2 * np.pi * turned[:, None] * shares))

    course.append(seconds, "transfer", wobble)
    course.hold()


def _flow(course: _Course) -> None:
    """Through several places without a stop."""
    rng, begin_s = course.rng, course.end_s
    passed = [course.q]
    for _ in range(int(rng.integers(3, 6))):
        passed.append(course.places.draw(passed[-1]))
    ways = [float(np.max(np.abs(b - a))) for a, b in pairwise(passed)]
    speed = rng.uniform(*course.pace.speeds)
    times = np.concatenate([[0], np.cumsum([max(course.pace.least_s, 1.4 * way / speed) for way in ways])])
    at_rest = [(1, np.zeros(len(course.q))), (2, np.zeros(len(course.q)))]
    at_both_ends: Any = (at_rest, at_rest)  # SciPy takes derivatives here, its stubs do not know
    spline = make_interp_spline(times, np.array(passed), k=5, bc_type=at_both_ends)
    course.append(float(times[-1]), "transfer", lambda t: np.asarray(spline(np.clip(t - begin_s, 0, times[-1]))))
    course.q = passed[-1]
    course.hold()
