"""What the arm is told to do: attitudes and holds as a procedure has them, sums of sines, or both, on the grid of time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.ndimage import uniform_filter1d

from bench.stranger.arms import Arm
from bench.stranger.array import Array
from bench.stranger.signals import PAD, STEP_S

QUARTER = np.pi / 2
LONGEST_S = 92.0
"""After which no further attitude is gone to."""

Doing = Literal["hold", "move"]


@dataclass(frozen=True)
class Stretch:
    """What the arm does from one time to another, s."""

    begin_s: float
    end_s: float
    doing: Doing


@dataclass(frozen=True)
class Path:
    """Commanded joints (N, n) on the grid, rad, and the stretches they are made of."""

    q: Array
    stretches: tuple[Stretch, ...]


class Course:
    """A path under construction: every call adds a stretch from where the last one ended."""

    def __init__(self, rng: np.random.Generator, arm: Arm, start: Array, speed: float, acceleration: float, abrupt: bool) -> None:
        """Begins at joints (n,), rad; speed in rad/s and acceleration in rad/s^2 of the joint that goes farthest."""
        self.rng, self.arm, self.q = rng, arm, start
        self.speed, self.acceleration, self.abrupt = speed, acceleration, abrupt
        self.time = 0.0
        self.parts: list[Array] = []
        self.stretches: list[Stretch] = []

    def hold(self, seconds: float) -> None:
        """Stands still."""
        self._append(np.repeat(self.q[None], int(seconds / STEP_S), 0), "hold")

    def hold_a_while(self) -> None:
        """Stands still for 2.2 to 4.5 s."""
        self.hold(self.rng.uniform(2.2, 4.5))

    def move(self, to: Array) -> None:
        """Goes straight to joints (n,), rad: with a trapezium of speed where the motion is abrupt, else by a polynomial of fifth order."""
        way = np.abs(to - self.q).max()
        s = self._ramp_speed(way) if self.abrupt else self._ease(way)
        self._append(self.q + s[:, None] * (to - self.q), "move")
        self.q = to

    def swing(self, seconds: float, joints: Sequence[int], slowest_hz: float = 0.1, harmonics: int = 5, speed: float = 0.5) -> None:
        """Moves joints by sums of sines around where they are, each at most as fast as `speed` in rad/s, from rest to rest."""
        n = int(seconds / STEP_S)
        t = np.arange(n) * STEP_S
        window = np.clip(np.minimum(t, seconds - t) / 1.5, 0, 1)
        window = window**3 * (10 - 15 * window + 6 * window**2)
        y = np.repeat(self.q[None], n, 0)
        for joint in joints:
            s = np.zeros(n)
            for k in range(1, harmonics + 1):
                s = s + self.rng.normal() / k * np.sin(2 * np.pi * slowest_hz * k * t + self.rng.uniform(0, 6.28))
            s = s * window
            s = s * (speed / np.abs(np.gradient(s, STEP_S)).max() * (1 if joint >= self.arm.pitch - 2 else 0.4))
            farthest = 0.6 if joint == self.arm.pitch else 1.3
            y[:, joint] += s * min(1, farthest / np.abs(s).max())
        self._append(y, "move")

    def finish(self) -> Path:
        """With rest before and after, its corners rounded off."""
        q = np.vstack(self.parts)
        q = np.vstack([np.repeat(q[:1], PAD, 0), q, np.repeat(q[-1:], PAD, 0)])
        for width in (41, 21) if self.abrupt else (15, 9):
            q = uniform_filter1d(q, width, axis=0, mode="nearest")
        return Path(q, tuple(self.stretches))

    def _append(self, q: Array, doing: Doing) -> None:
        self.parts.append(q)
        end = self.time + len(q) * STEP_S
        self.stretches.append(Stretch(self.time, end, doing))
        self.time = end

    def _ramp_speed(self, way: float) -> Array:
        """(N,), the share of a way in rad that is done, with constant accelerations."""
        ramp = self.speed / self.acceleration
        seconds = max(way / self.speed + ramp, 2 * ramp)
        t = np.arange(int(seconds / STEP_S)) * STEP_S
        s = np.cumsum(np.minimum(1, np.minimum(t / ramp, (seconds - t) / ramp)))
        return np.asarray((s - s[0]) / (s[-1] - s[0]))

    def _ease(self, way: float) -> Array:
        """(N,), the share of a way in rad that is done, without jerk at its ends."""
        n = int(max(way * 1.875 / self.speed, 0.8) / STEP_S)
        x = np.arange(n) / (n - 1)
        return np.asarray(10 * x**3 - 15 * x**4 + 6 * x**5)


def draw_attitude(rng: np.random.Generator, arm: Arm, wrist: tuple[float, float, float] | None = None, spread: float = 1.0) -> Array:
    """(n,), rad: the arm half stretched out; the wrist (pitch, mid, roll) anywhere or as it is given."""
    q = np.zeros(len(arm.joints))
    lift = -0.25 + rng.uniform(-0.25, 0.25) * spread
    q[0] = rng.uniform(-0.7, 0.7) * spread
    q[1] = lift
    q[arm.elbow] = -lift + rng.uniform(-0.2, 0.2) * spread
    if wrist is None:
        wrist = rng.uniform(-1.5, 1.5), rng.uniform(-1.2, 1.2), rng.uniform(-2, 2)
    q[arm.pitch], q[arm.mid], q[arm.roll] = wrist
    return q


def draw_motion(rng: np.random.Generator, arm: Arm, kind: str) -> Path:
    """A motion of a kind, which starts and stops abruptly where the kind ends in an exclamation mark.

    Args:
        kind: `proc` (the sensor's axes along gravity, one after the other), `att` (any attitudes), `exc` (sums of sines) or `mix`
            (attitudes, and sines of one joint at a time).
    """
    speed, acceleration = rng.uniform(0.34, 0.5), rng.uniform(1.5, 4.0)
    abrupt, kind = kind.endswith("!"), kind.rstrip("!")
    way = _draw_way(rng, arm, kind)
    course = Course(rng, arm, way[0], speed, acceleration, abrupt)
    course.hold(2 + rng.uniform(1, 2))
    if kind in ("proc", "att"):
        _visit(course, way)
    elif kind == "exc":
        _excite(course, way)
    else:
        _visit_and_swing(course, way)
    return course.finish()


def _draw_way(rng: np.random.Generator, arm: Arm, kind: str) -> list[Array]:
    """Attitudes to go to, the first of them the start."""
    if kind == "proc":
        return _draw_procedure(rng, arm)
    if kind == "att":
        return [draw_attitude(rng, arm) for _ in range(rng.integers(7, 10))]
    return [draw_attitude(rng, arm, spread=0.5) for _ in range(3 if kind == "exc" else 5)]


def _draw_procedure(rng: np.random.Generator, arm: Arm) -> list[Array]:
    """Attitudes that turn one axis of the sensor after the other along gravity."""
    base = draw_attitude(rng, arm, (0, 0, 0), 0.6)
    base[arm.elbow] = -base[1]
    roll = rng.choice([-QUARTER, 0, QUARTER])
    side = rng.choice([-1, 1])
    mounted = np.pi / 4 if arm.name == "offset6" else 0
    E = np.eye(len(arm.joints))
    beyond = roll - 2 * QUARTER if roll >= 0 else roll + 2 * QUARTER
    wrists = [
        (side * QUARTER, roll),
        (side * QUARTER, roll + QUARTER),
        (side * QUARTER, roll),
        (0, roll),
        (0, roll + QUARTER),
        (0, roll - QUARTER),
        (0, beyond),
        (-side * QUARTER, roll),
    ]
    way = [base + E[arm.pitch] * pitch + E[arm.roll] * (angle + mounted) for pitch, angle in wrists]
    if rng.random() < 0.4:
        way.pop(1)
    return way


def _visit(course: Course, way: Sequence[Array]) -> None:
    for attitude in way[1:]:
        course.move(attitude)
        course.hold_a_while()
        if course.time > LONGEST_S:
            break


def _excite(course: Course, way: Sequence[Array]) -> None:
    rng, arm = course.rng, course.arm
    wrist = [arm.pitch, arm.mid, arm.roll]
    seconds = rng.uniform(20, 27)
    joints = wrist + ([0, 1] if rng.random() < 0.5 else [])
    course.swing(seconds, joints, speed=rng.uniform(0.4, 0.6))
    course.hold(3)
    course.move(way[1])
    course.hold(3)
    seconds, slowest = rng.uniform(15, 22), rng.uniform(0.1, 0.2)
    course.swing(seconds, [*wrist, 0], slowest_hz=slowest, speed=rng.uniform(0.4, 0.6))
    course.hold(3)
    course.move(way[2])
    course.hold(3)


def _visit_and_swing(course: Course, way: Sequence[Array]) -> None:
    rng, arm = course.rng, course.arm
    for i, attitude in enumerate(way[1:]):
        course.move(attitude)
        course.hold_a_while()
        if i % 2 == 0:
            joint = (arm.roll, arm.pitch, arm.mid)[(i // 2) % 3]
            seconds = rng.uniform(9, 13)
            course.swing(seconds, [joint], slowest_hz=rng.uniform(0.12, 0.25), harmonics=2)
            course.hold(2)
