"""Something outside touches the payload during part of the run."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.cable import RUBBING
from core.plant.faults.draws import direction, draw_log_uniform, moment, seed_of, three
from core.plant.faults.fault import Act, Fault, Machine, Setting, Three
from core.plant.faults.grip import Grip, grip_of


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
        """Force of 1 to 15 N in any direction, 3 to 10 cm from the sensor, for 3 to 20 % of the run."""
        force = size * draw_log_uniform(rng, 1.0, 15.0) * direction(rng)
        return cls(three(force), grip_of(rng), *window_of(rng, setting))

    def act(self, machine: Machine) -> Act | None:
        """Pushes at the grip by `force_n` times `strength` while the touch lasts."""
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
        """A touch as `Touch` draws it, with ramps of 15 to 50 % of its time."""
        force = size * draw_log_uniform(rng, 1.0, 15.0) * direction(rng)
        return cls(three(force), grip_of(rng), *window_of(rng, setting), float(rng.uniform(0.15, 0.5)))

    def strength(self) -> Callable[[float], float]:
        """Rises from 0 to 1 within `ramp_share`, and falls likewise at the end."""
        return lambda x: min(x / self.ramp_share, (1 - x) / self.ramp_share, 1.0)


@dataclass(frozen=True)
class Bumps(Touch):
    """Several short bumps, half sines of about 0.2 s, of different strength."""

    variant = "bumps"

    count: int
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """A touch as `Touch` draws it, of two to five bumps."""
        force = size * draw_log_uniform(rng, 1.0, 15.0) * direction(rng)
        begin, duration = window_of(rng, setting)
        return cls(three(force), grip_of(rng), begin, duration, int(rng.integers(2, 6)), seed_of(rng))

    def strength(self) -> Callable[[float], float]:
        """Half sines of height 0.5 to 1 at random places, which `seed` fixes; 0 between them."""
        rng = np.random.default_rng(self.seed)
        centres = (np.arange(self.count) + rng.uniform(0.3, 0.7, self.count)) / self.count
        sizes = rng.uniform(0.5, 1.0, self.count)
        half = min(0.1 / self.duration_s, 0.3 / self.count)

        def bump(x: float) -> float:
            k = int(np.argmin(np.abs(x - centres)))
            return float(sizes[k]) * max(math.cos(0.5 * math.pi * min(abs(x - float(centres[k])) / half, 1.0)), 0.0)

        return bump


@dataclass(frozen=True)
class Cushion(Touch):
    """Leans against something soft that stands still: the force is the stated one where the touch begins, and grows or vanishes with the
    way into it or out of it, over `depth`; never more than twice as much."""

    variant = "cushion"

    depth_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """A touch as `Touch` draws it, against a cushion 2 to 20 cm deep."""
        force = size * draw_log_uniform(rng, 1.0, 15.0) * direction(rng)
        return cls(three(force), grip_of(rng), *window_of(rng, setting), draw_log_uniform(rng, 0.02, 0.2))

    def act(self, machine: Machine) -> Act | None:
        """Pushes at the grip by `force_n` times 1 where the touch begins, more against the force and less along it, from 0 to 2."""
        grip, force = Grip(machine, np.array(self.at_m)), np.array(self.force_n)
        inward = -force / (math.sqrt(float(force @ force)) * self.depth_m)
        first: Array | None = None

        def press(t: float) -> None:
            nonlocal first
            if 0 <= t - self.begin_s < self.duration_s:
                place = grip.place()
                first = place if first is None else first
                grip.push(place, min(max(1 + float(inward @ (place - first)), 0.0), 2.0) * force)

        return press


@dataclass(frozen=True)
class Curtain(Fault):
    """Hangs or stands in the way at some place, a strip curtain or a foam wall: each time that the payload is in it, it is pushed back,
    over `depth` to the full force, and rubbed along; free outside of it."""

    id = "external_contact"
    variant = "curtain"

    force_n: float
    outward: Three
    """Unit vector, world frame."""
    clearance_m: float
    """From the payload at home."""
    depth_m: float
    friction_share: float
    at_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 15 N in any direction, 1 to 6 cm away at home and 3 to 15 cm deep, friction of 20 to 60 %, 3 to 10 cm from the sensor."""
        force, outward = size * draw_log_uniform(rng, 1.0, 15.0), three(direction(rng))
        clearance, depth = draw_log_uniform(rng, 0.01, 0.06), draw_log_uniform(rng, 0.03, 0.15)
        return cls(force, outward, clearance, depth, float(rng.uniform(0.2, 0.6)), grip_of(rng))

    def act(self, machine: Machine) -> Act | None:
        """Pushes at the grip, out of the curtain by `force` times the share of the depth, and against its way along the curtain."""
        grip, outward = Grip(machine, np.array(self.at_m)), np.array(self.outward)
        begins = float(outward @ grip.place()) - self.clearance_m

        def brush(_: float) -> None:
            place = grip.place()
            v = grip.velocity(place)
            inside = begins - float(outward @ place)
            if inside > 0:
                pressed = self.force_n * min(inside / self.depth_m, 1.0)
                along = v - float(outward @ v) * outward
                rubbing = self.friction_share / math.sqrt(RUBBING**2 + float(along @ along))
                grip.push(place, pressed * (outward - rubbing * along))

        return brush


CONTACT: tuple[type[Fault], ...] = (
    Touch,
    GrowingTouch,
    Bumps,
    Cushion,
    Curtain,
)
