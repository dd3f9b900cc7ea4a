"""What the arm does: stations one after another, at each a turn of the sensor about one of its axes, there and back."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from bench.second_stranger.arms import Arm
from bench.second_stranger.array import Array
from bench.second_stranger.stations import Attitude, Surveyor

Path = Callable[[Array], Array]
PROFILE_STEP_S = 5e-4


@dataclass(frozen=True)
class Stretch:
    """A part of the motion, from a time to another, s: what it is, and the joints (N, n), rad, at times (N,), s, in it."""

    begin_s: float
    end_s: float
    label: str
    follow: Path


class Pace(NamedTuple):
    """How fast turns are: between which speeds, rad/s, and accelerations, rad/s^2; and how long these take to build up, s."""

    speeds: tuple[float, float]
    accelerations: tuple[float, float]
    smooth_s: float = 0.12


PACES = {
    "paper": Pace((0.6, 1.1), (2.5, 4.8)),
    "sweep": Pace((0.5, 0.9), (1.5, 3)),
    "mixed": Pace((0.5, 1.0), (1.5, 4)),
    "free": Pace((0.45, 0.9), (1.5, 3)),
    "fast": Pace((1.9, 2.6), (8, 12), 0.08),
    "poor": Pace((0.5, 0.9), (2, 3.5)),
    "jerky": Pace((1.0, 1.5), (6, 9), 0.025),
}
"""By kind of motion."""
TRANSFER_SPEEDS = {"fast": 2.0, "jerky": 1.2}
"""rad/s, where they are not drawn."""
HURRIED = ("fast", "jerky")


class _Score:
    """Stretches as they are put one behind the other."""

    def __init__(self, smooth_s: float) -> None:
        self.stretches: list[Stretch] = []
        self.end_s = 0.0
        self._smooth_s = smooth_s

    def hold(self, q: Array, seconds: float, label: str) -> None:
        """At joints (n,), rad."""
        self._append(seconds, label, lambda t: np.tile(q, (len(t), 1)))

    def move(self, path: Path, length: float, speed: float, acceleration: float, label: str) -> None:
        """Along a path from 0 to 1 with a length in rad, at most with a speed and about with an acceleration, rad and s."""
        seconds, share = _time_smoothly(length, speed, acceleration, self._smooth_s)
        begin_s = self.end_s
        self._append(seconds, label, lambda t: path(share(t - begin_s)))

    def _append(self, seconds: float, label: str, follow: Path) -> None:
        self.stretches.append(Stretch(self.end_s, self.end_s + seconds, label, follow))
        self.end_s += seconds


def draw_motion(rng: np.random.Generator, arm: Arm, kind: str, seconds: float, gravity_sign: float) -> list[Stretch]:
    """Stretches that take about so long, of a kind that `PACES` has, under a gravity whose z has a sign."""
    surveyor = Surveyor(arm, rng, gravity_sign)
    pace = PACES[kind]
    drawn = rng.uniform(0.8, 1.3)
    transfer_speed = TRANSFER_SPEEDS.get(kind, drawn)
    score = _Score(pace.smooth_s)
    attitudes = _Attitudes(rng, kind)
    q: Array | None = None
    place = -1
    while score.end_s < seconds - 4:
        place += 1
        attitude, axis = attitudes.draw(place)
        angle = rng.uniform(1.0, 1.75) * rng.choice([-1, 1])
        if kind in ("sweep", "mixed", *HURRIED) and attitude is not None and axis != attitude[0] and rng.random() < 0.5:
            angle = np.sign(angle) * np.pi / 2
        station = surveyor.find_station(q, attitude, axis, angle)
        if station is None:
            continue
        if q is not None:
            path, length = _go_straight(q, station.q)
            score.move(path, max(length, 0.05), transfer_speed, min(pace.accelerations[1], 6), "transfer")
        _turn_there_and_back(rng, surveyor, score, pace, station.q, station.path, axis, angle, kind in HURRIED)
        q = station.q
    return score.stretches


class _Attitudes:
    """In which the sensor is turned, and about which axis."""

    def __init__(self, rng: np.random.Generator, kind: str) -> None:
        self._rng = rng
        self._kind = kind
        self._all: list[Attitude] = [(0, 1), (1, -1), (2, 1), (0, -1), (1, 1), (2, -1)]
        rng.shuffle(self._all)
        self._few: list[Attitude] = [(2, 1), (2, -1)] if rng.random() < 0.5 else [(2, 1), (0, 1)]

    def draw(self, place: int) -> tuple[Attitude | None, int]:
        """For the station at a place in the motion."""
        if self._kind == "free":
            return None, int(self._rng.integers(3))
        if self._kind == "poor":
            attitude = self._few[place % 2]
            return attitude, attitude[0]
        attitude = self._all[place % 6]
        if self._kind == "paper" or (self._kind != "sweep" and place % 2 == 0):
            return attitude, attitude[0]
        return attitude, (attitude[0] + 1 + int(self._rng.integers(2))) % 3


def _go_straight(start: Array, end: Array) -> tuple[Path, float]:
    """In the space of joints (n,), rad; and by how much the one turns that turns most."""
    by = end - start
    return lambda share: np.asarray(start + share[:, None] * by), float(np.max(np.abs(by)))


def _turn_there_and_back(
    rng: np.random.Generator,
    surveyor: Surveyor,
    score: _Score,
    pace: Pace,
    q: Array,
    path: CubicSpline,
    axis: int,
    angle: float,
    is_hurried: bool,
) -> None:
    """With holds before, between and after."""
    pause_s = (0.6, 1.1) if is_hurried else (0.9, 1.6)
    speed, acceleration = rng.uniform(*pace.speeds), rng.uniform(*pace.accelerations)
    label = f"rotate:{'xyz'[axis]}"
    first, last = np.asarray(path(0.0)), np.asarray(path(1.0))
    score.hold(q, rng.uniform(*pause_s), surveyor.label_hold(q))
    score.move(lambda share: np.asarray(path(share)), abs(angle), speed, acceleration, label)
    score.hold(last, rng.uniform(*pause_s), surveyor.label_hold(last))
    score.move(lambda share: np.asarray(path(1 - share)), abs(angle), speed, acceleration, label)
    score.hold(first, rng.uniform(*pause_s), surveyor.label_hold(first))


def _time_smoothly(length: float, speed: float, acceleration: float, smooth_s: float) -> tuple[float, Path]:
    """How long it takes, s, and which share of the way is done at times (N,), s: a box of speed that was averaged three times."""
    h = PROFILE_STEP_S
    v = min(speed, np.sqrt(length * acceleration * 0.9))
    rise_s = max(v / acceleration, smooth_s)
    seconds = length / v
    t = np.arange(0, seconds + rise_s + 2 * smooth_s + 6 * h, h)
    profile = (t < seconds) * 1.0
    for width_s in (rise_s, smooth_s, smooth_s * 0.5):
        n = max(1, round(width_s / h))
        profile = np.convolve(profile, np.ones(n) / n)[: len(profile)]
    done = np.concatenate([[0], np.cumsum((profile[1:] + profile[:-1]) / 2)]) * h
    done *= 1 / done[-1]
    last = np.argmax(done > 1 - 1e-12)
    spline = CubicSpline(t[: last + 1], done[: last + 1], bc_type="clamped")
    end_s = t[last]
    return end_s, lambda x: np.where(x >= end_s, 1.0, spline(np.clip(x, 0, end_s)))


def follow_motion(stretches: Sequence[Stretch], t: Array) -> Array:
    """(N, n), rad: the joints at times (N,), s."""
    end_s = stretches[-1].end_s
    q = np.zeros((len(t), stretches[0].follow(t[:1]).shape[1]))
    for stretch in stretches:
        until = t <= stretch.end_s if stretch.end_s >= end_s - 1e-9 else t < stretch.end_s
        within = (t >= stretch.begin_s) & until
        q[within] = stretch.follow(t[within])
    return q
