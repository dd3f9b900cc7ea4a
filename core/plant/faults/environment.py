"""Something outside pulls at the payload or touches it: real forces on its body."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.plant.faults.draws import direction, moment, seed_of, spread, three
from core.plant.faults.fault import Act, Array, Fault, Machine, Setting, Three

RUBBING = 0.002
"""m/s; dry friction of a cable or a contact reaches its full size at this speed."""


def cross(a: Array, b: Array) -> Array:
    """(3,); numpy's own takes ten times as long."""
    ax, ay, az = a.tolist()
    bx, by, bz = b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


class Grip:
    """A point of the payload that forces act on.

    Args:
        local: (3,), in the sensor frame, m.
    """

    def __init__(self, machine: Machine, local: Array) -> None:
        self._data, self._body, self._local = machine.data, machine.body("payload"), local
        self._period = machine.period
        self._last: Array | None = None

    def place(self) -> Array:
        """(3,), in the world frame, m."""
        data, body = self._data, self._body
        return np.asarray(data.xpos[body] + data.xmat[body].reshape(3, 3) @ self._local)

    def velocity(self, place: Array) -> Array:
        """(3,), m/s, from the difference to the place given last; zero the first time. To be asked once per period."""
        last, self._last = self._last, place
        return np.zeros(3) if last is None else (place - last) / self._period

    def push(self, place: Array, force: Array) -> None:
        """Applies a force (3,), world frame, N, at a place in the world."""
        data, body = self._data, self._body
        applied = data.xfrc_applied[body]
        applied[:3] += force
        applied[3:] += cross(place - data.xipos[body], force)


def anchor(rng: np.random.Generator) -> Three:
    """Where a cable comes from, seen from the payload at home, world axes: above it and to a side, 0.3 to 0.9 m away."""
    away = direction(rng)
    away[2] = abs(away[2])
    return three(rng.uniform(0.3, 0.9) * away)


def grip_of(rng: np.random.Generator) -> Three:
    """Where it is fixed on the payload: 3 to 10 cm from the sensor."""
    return three(rng.uniform(0.03, 0.1) * direction(rng))


@dataclass(frozen=True)
class SpringCable(Fault):
    """A hose that pulls like a spring (0.5 to 10 N/m) towards a fixed point, with friction of 0.1 to 1 N against the motion."""

    id = "cable_drag"
    variant = "spring"

    stiffness_n_per_m: float
    friction_n: float
    anchor_from_home_m: Three
    grip_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * spread(rng, 0.5, 10.0), size * spread(rng, 0.1, 1.0), anchor(rng), grip_of(rng))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`."""
        grip = Grip(machine, np.array(self.grip_m))
        fixed = grip.place() + np.array(self.anchor_from_home_m)

        def pull(_: float) -> None:
            place = grip.place()
            v = grip.velocity(place)
            friction = self.friction_n / math.sqrt(RUBBING**2 + float(v @ v))
            grip.push(place, self.pull(fixed - place) - friction * v)

        return pull

    def pull(self, away: Array) -> Array:
        """(3,), N, towards the fixed point at `away` (3,), m, from the grip."""
        return self.stiffness_n_per_m * away


@dataclass(frozen=True)
class SlackCable(SpringCable):
    """A cable that hangs slack within reach and tightens beyond its length, five to ten times as stiff as a hose."""

    variant = "end_stop"

    slack_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        away = anchor(rng)
        slack = float(np.linalg.norm(away)) * float(rng.uniform(0.85, 1.05))
        return cls(size * spread(rng, 5.0, 50.0), size * spread(rng, 0.05, 0.2), away, grip_of(rng), slack)

    def pull(self, away: Array) -> Array:
        """See `SpringCable.pull`."""
        length = math.sqrt(float(away @ away))
        return max(1 - self.slack_m / length, 0.0) * self.stiffness_n_per_m * away


@dataclass(frozen=True)
class TwistedHose(Fault):
    """A hose pack along the wrist resists its turning: a torque about the last joint's axis, softer at first, with memory (Dahl)."""

    id = "cable_drag"
    variant = "torsion"

    stiffness_n_m_per_rad: float
    neutral_rad: float
    friction_n_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * spread(rng, 0.05, 0.5), float(rng.uniform(-1.5, 1.5)), size * spread(rng, 0.01, 0.05))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`."""
        data, body = machine.data, machine.body("payload")
        wrist = int(np.arange(machine.model.nv)[machine.motors][-1])
        last = float(data.qpos[wrist])
        z = 0.0

        def twist(_: float) -> None:
            nonlocal last, z
            q = float(data.qpos[wrist])
            dq, last = q - last, q
            z += dq - abs(dq) * z / 0.05  # the friction builds up over 0.05 rad
            turn = q - self.neutral_rad
            torque = -self.stiffness_n_m_per_rad * turn * (0.5 + 0.5 * min(turn * turn, 4.0)) - self.friction_n_m * z / 0.05
            data.xfrc_applied[body, 3:] += torque * data.xaxis[wrist]

        return twist


def window_of(rng: np.random.Generator, setting: Setting) -> tuple[float, float]:
    """Begin and length of a touch, s."""
    return moment(rng, setting), float(rng.uniform(0.03, 0.2)) * setting.seconds


@dataclass(frozen=True)
class Touch(Fault):
    """Somebody leans on the payload: a constant force of 1 to 15 N in the world during part of the run."""

    id = "external_contact"
    variant = "window"

    force_n: Three
    at_m: Three
    begin_s: float
    duration_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        force = size * spread(rng, 1.0, 15.0) * direction(rng)
        return cls(three(force), grip_of(rng), *window_of(rng, setting))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`."""
        grip, force, strength = Grip(machine, np.array(self.at_m)), np.array(self.force_n), self.strength()

        def lean(t: float) -> None:
            x = (t - self.begin_s) / self.duration_s
            if 0 <= x < 1:
                grip.push(grip.place(), strength(x) * force)

        return lean

    def strength(self) -> Callable[[float], float]:
        """The share of the force over the course x of the touch, 0 to 1."""
        return lambda _: 1.0


@dataclass(frozen=True)
class GrowingTouch(Touch):
    """A touch that comes and goes over `ramp_share` of its time at either end."""

    variant = "ramps"

    ramp_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        force = size * spread(rng, 1.0, 15.0) * direction(rng)
        return cls(three(force), grip_of(rng), *window_of(rng, setting), float(rng.uniform(0.15, 0.5)))

    def strength(self) -> Callable[[float], float]:
        """See `Touch.strength`."""
        return lambda x: min(x / self.ramp_share, (1 - x) / self.ramp_share, 1.0)


@dataclass(frozen=True)
class Bumps(Touch):
    """Several short bumps, half sines of about 0.2 s, of different strength."""

    variant = "bumps"

    count: int
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        force = size * spread(rng, 1.0, 15.0) * direction(rng)
        begin, duration = window_of(rng, setting)
        return cls(three(force), grip_of(rng), begin, duration, int(rng.integers(2, 6)), seed_of(rng))

    def strength(self) -> Callable[[float], float]:
        """See `Touch.strength`."""
        rng = np.random.default_rng(self.seed)
        centres = (np.arange(self.count) + rng.uniform(0.3, 0.7, self.count)) / self.count
        sizes = rng.uniform(0.5, 1.0, self.count)
        half = min(0.1 / self.duration_s, 0.3 / self.count)

        def bump(x: float) -> float:
            k = int(np.argmin(np.abs(x - centres)))
            return float(sizes[k]) * max(math.cos(0.5 * math.pi * min(abs(x - float(centres[k])) / half, 1.0)), 0.0)

        return bump


ENVIRONMENT: tuple[type[Fault], ...] = (SpringCable, SlackCable, TwistedHose, Touch, GrowingTouch, Bumps)
