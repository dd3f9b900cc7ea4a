"""What a machine does: ways between places in the space of its joints, and excitations by sums of sines at some of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
import pinocchio as pin

from bench.fourth_stranger.machines import Machine, load_machine
from bench.second_stranger.array import Array
from bench.second_stranger.motions import Stretch
from bench.second_stranger.signals import rise

Kind = Literal["stairs", "sines", "dash", "pick", "crawl", "once", "hasty"]
CANDIDATES, FARTHEST_RAD, FARTHEST_BASE_RAD, REMEMBERED = 20, 2.2, 1.5, 5
LEAST_REACH_M, ALIGNED_RAD = 0.18, 0.03
STATIONS = 4
"""Of a `pick`, between which it goes round."""
RAMP_S = 0.06
"""In which a hasty way is at its speed."""
RISE_PEAK = 1.875
"""Greatest slope of `rise`."""
LINKED_LOW, LINKED_HIGH = np.array([-1.5, -1.5, 0.6, 0.0, -2.9]), np.array([1.5, -0.5, 1.7, 0.0, 2.9])
"""rad, between which a linked machine works."""


class Pace(NamedTuple):
    """Greatest speed, rad/s, of the joint that turns most; how long stops last, s; and the least that a way takes, s."""

    speeds: tuple[float, float]
    stops_s: tuple[float, float]
    least_s: float


PACES: dict[Kind, Pace] = {
    "stairs": Pace((0.7, 1.4), (0.8, 2.4), 0.8),
    "sines": Pace((0.8, 1.3), (0.8, 1.8), 0.8),
    "dash": Pace((2.0, 2.8), (0.5, 1.1), 0.5),
    "pick": Pace((0.9, 1.6), (0.7, 1.3), 0.7),
    "crawl": Pace((0.35, 0.6), (1.8, 4.0), 2.4),
    "once": Pace((1.0, 1.5), (1.0, 1.3), 0.8),
    "hasty": Pace((0.9, 1.4), (0.5, 1.2), 0.4),
}


class _Course:
    """Stretches as they are put one behind the other, and the places that they lead to."""

    def __init__(self, rng: np.random.Generator, machine: Machine, up: Array, kind: Kind) -> None:
        self.rng, self.machine, self.kind, self.pace = rng, machine, kind, PACES[kind]
        self._up = up
        self._model = load_machine(machine)
        self._data = self._model.createData()
        self._frame = self._model.getFrameId("ft_sensor")
        self._seen: list[Array] = []
        share = 0.85 if kind in ("sines", "once") else 1.0
        high = share * np.minimum(machine.angle_limits - 0.1, 2.9)
        high[0] = min(high[0], FARTHEST_BASE_RAD)
        self._low: Array = LINKED_LOW if machine.is_linked else -high
        self._high: Array = LINKED_HIGH if machine.is_linked else high
        self.stretches: list[Stretch] = []
        self.end_s = 0.0
        self.q = self.draw_place(None)

    def draw_place(self, before: Array | None) -> Array:
        """Joints (n,), rad, not too far from those before; of many, the one in the newest attitude."""
        found: list[tuple[float, Array, Array]] = []
        while len(found) < CANDIDATES:
            q = self.rng.uniform(self._low, self._high)
            if before is not None:
                q = np.clip(q, before - FARTHEST_RAD, before + FARTHEST_RAD)
            q = self.machine.link(q)
            at = self._locate(q)
            least = self.machine.least_height_m
            if np.linalg.norm(at.translation[:2]) < LEAST_REACH_M or (least is not None and at.translation[2] < least):
                continue
            up = np.concatenate([at.rotation.T @ self._up, 0.4 * at.rotation[:, 0]])
            nearest = max((float(up @ other) for other in self._seen[-REMEMBERED:]), default=0.0)
            found.append((nearest, q, up))
        _, q, up = min(found, key=lambda each: each[0])
        self._seen.append(up)
        return q

    def hold(self, seconds: float | None = None) -> None:
        """Where the machine is."""
        q = self.q
        self._append(seconds or self.rng.uniform(*self.pace.stops_s), self._label_hold(q), lambda t: np.tile(q, (len(t), 1)))

    def go(self, to: Array) -> None:
        """Straight to joints (n,), rad, smoothly, or at one speed in between where all is hasty."""
        start, begin_s, way = self.q, self.end_s, float(np.max(np.abs(to - self.q)))
        speed = self.machine.pace * self.rng.uniform(*self.pace.speeds)
        self.q = to
        if self.kind == "hasty":
            cruise_s = max(self.pace.least_s, way / speed)
            self._append(cruise_s + RAMP_S, "transfer", lambda t: start + _hasten(t - begin_s, cruise_s)[:, None] * (to - start))
            return
        seconds = max(self.pace.least_s / self.machine.pace, way * RISE_PEAK / speed)
        self._append(seconds, "transfer", lambda t: start + rise((t - begin_s) / seconds)[:, None] * (to - start))

    def excite(self, seconds: float) -> None:
        """Each joint by a sum of sines of its own, about where the machine is."""
        rng, q, begin_s, n = self.rng, self.q, self.end_s, len(self.q)
        hz = rng.uniform(0.15, 0.5, n)[:, None] * np.array([1, 2, 3.3]) * self.machine.pace
        amplitudes = rng.uniform(0.06, 0.2, (n, 3)) / np.array([1, 1.7, 4.0])
        amplitudes[0] *= 0.6
        phases = rng.uniform(0, 2 * np.pi, (n, 3))

        def wobble(t: Array) -> Array:
            x = t - begin_s
            swing = np.sum(amplitudes * np.sin(2 * np.pi * x[:, None, None] * hz + phases), 2)
            envelope = rise(x / 1.1) * rise((seconds - x) / 1.1)
            return self.machine.link(q + envelope[:, None] * swing)

        self._append(seconds, "transfer", wobble)

    def _append(self, seconds: float, label: str, follow: Callable[[Array], Array]) -> None:
        self.stretches.append(Stretch(self.end_s, self.end_s + seconds, label, follow))
        self.end_s += seconds

    def _label_hold(self, q: Array) -> str:
        """Which axis of the sensor lies along gravity at joints (n,), rad."""
        down = -(self._locate(q).rotation.T @ self._up)
        axis = int(np.argmax(np.abs(down)))
        return f"hold:{'xyz'[axis]}{'+' if down[axis] > 0 else '-'}" if abs(down[axis]) > np.cos(ALIGNED_RAD) else "hold:free"

    def _locate(self, q: Array) -> pin.SE3:
        pin.framesForwardKinematics(self._model, self._data, q)
        return self._data.oMf[self._frame]


def _hasten(t: Array, cruise_s: float) -> Array:
    """(N,), from 0 to 1 at times (N,), s: soon up to one speed, and down from it after so many s."""

    def run(x: Array) -> Array:
        within = np.clip(x, 0, 1)
        return np.asarray(within**4 * (2.5 - 3 * within + within**2) + np.maximum(x - 1, 0))

    return (run(t / RAMP_S) - run((t - cruise_s) / RAMP_S)) * RAMP_S / cruise_s


def draw_motion(rng: np.random.Generator, machine: Machine, up: Array, kind: Kind, seconds: float) -> list[Stretch]:
    """Stretches that take about so long; `up` (3,), base axes, is against gravity."""
    course = _Course(rng, machine, up, kind)
    if kind == "once":
        course.hold()
        course.excite(seconds - 2.3)
        course.hold()
        return course.stretches
    stations = [course.q, *(course.draw_place(course.q) for _ in range(STATIONS - 1))]
    course.hold(2.0)
    visited = 0
    while course.end_s < seconds - 4:
        visited += 1
        course.go(stations[visited % STATIONS] if kind == "pick" else course.draw_place(course.q))
        course.hold()
        if kind == "sines" and visited % 2 == 0:
            course.excite(rng.uniform(6, 9))
            course.hold()
    course.hold(1.5)
    return course.stretches
