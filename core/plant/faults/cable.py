"""A cable or a hose pulls at the payload."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import direction, draw_log_uniform, three
from core.plant.faults.fault import Act, Fault, Machine, Setting, Three
from core.plant.faults.grip import Grip, grip_of

RUBBING = 0.002
"""m/s; dry friction of a cable or a contact reaches its full size at this speed."""
NEAR = 0.05
"""m; nearer than this to its reel a cable goes slack."""
TAUT = 1.03
"""A hose is at least so many times as long as the way between its ends."""


def anchor(rng: np.random.Generator) -> Three:
    """Where a cable comes from, seen from the payload at home, world axes: above it and to a side, 0.3 to 0.9 m away."""
    away = direction(rng)
    away[2] = abs(away[2])
    return three(rng.uniform(0.3, 0.9) * away)


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
        """0.5 to 10 N/m, friction of 0.1 to 1 N, anchor 0.3 to 0.9 m from the payload at home, grip 3 to 10 cm from the sensor."""
        return cls(size * draw_log_uniform(rng, 0.5, 10.0), size * draw_log_uniform(rng, 0.1, 1.0), anchor(rng), grip_of(rng))

    def act(self, machine: Machine) -> Act | None:
        """Pulls the grip by `pull` and rubs against its velocity by at most `friction_n`."""
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
        """5 to 50 N/m, friction of 0.05 to 0.2 N, slack of 0.85 to 1.05 of the anchor's distance at home."""
        away = anchor(rng)
        slack = float(np.linalg.norm(away)) * float(rng.uniform(0.85, 1.05))
        return cls(size * draw_log_uniform(rng, 5.0, 50.0), size * draw_log_uniform(rng, 0.05, 0.2), away, grip_of(rng), slack)

    def pull(self, away: Array) -> Array:
        """(3,), N, of a spring that begins at `slack_m`; zero for a nearer fixed point."""
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
        """0.05 to 0.5 N m/rad, neutral within 1.5 rad of zero, friction of 0.01 to 0.05 N m."""
        return cls(size * draw_log_uniform(rng, 0.05, 0.5), float(rng.uniform(-1.5, 1.5)), size * draw_log_uniform(rng, 0.01, 0.05))

    def act(self, machine: Machine) -> Act | None:
        """Twists the payload about the last joint's axis by a hardening spring and by Dahl's friction, which builds up over 0.05 rad."""
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


@dataclass(frozen=True)
class Reel(Fault):
    """A balancer or a hose reel: the same pull at any distance from its fixed point (0.5 to 5 N), `friction` of it more where it is wound
    off and less where it winds up."""

    id = "cable_drag"
    variant = "reel"

    pull_n: float
    friction_share: float
    anchor_from_home_m: Three
    grip_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Pull of 0.5 to 5 N, friction of 10 to 30 % of it, anchor and grip as of a `SpringCable`."""
        return cls(size * draw_log_uniform(rng, 0.5, 5.0), float(rng.uniform(0.1, 0.3)), anchor(rng), grip_of(rng))

    def act(self, machine: Machine) -> Act | None:
        """Pulls the grip towards the fixed point by `pull_n`, `friction_share` more where it is wound off and less where it winds up."""
        grip = Grip(machine, np.array(self.grip_m))
        fixed = grip.place() + np.array(self.anchor_from_home_m)

        def wind(_: float) -> None:
            place = grip.place()
            v = grip.velocity(place)
            away = fixed - place
            towards = away / max(math.sqrt(float(away @ away)), NEAR)
            paid_out = -float(v @ towards)
            pull = self.pull_n * (1 + self.friction_share * paid_out / math.hypot(RUBBING, paid_out))
            grip.push(place, pull * towards)

        return wind


def bow_of(ratio: float, guess: float) -> float:
    """u with `sinh(u) / u = ratio`, which is more than 1: half a catenary's width by its parameter. Newton's method on the logarithm, which
    is convex, from the last one on."""
    u = guess
    for _ in range(50):
        step = (math.log(math.sinh(u) / u) - math.log(ratio)) / (1 / math.tanh(u) - 1 / u)
        u = max(u - step, 0.5 * u)
        if abs(step) < 1e-12 * u:
            break
    return u


@dataclass(frozen=True)
class HangingHose(Fault):
    """A heavy hose that hangs between the payload and a fixed point and is longer than the way: it pulls by its own weight alone, along the
    catenary on which it hangs; more of it hangs at the higher end."""

    id = "cable_drag"
    variant = "catenary"

    weight_n_per_m: float
    length_m: float
    anchor_from_home_m: Three
    grip_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 8 N/m, 0.3 to 0.8 m longer than the way to its anchor at home, anchor and grip as of a `SpringCable`."""
        away = anchor(rng)
        length = float(np.linalg.norm(away)) + float(rng.uniform(0.3, 0.8))
        return cls(size * draw_log_uniform(rng, 1.0, 8.0), length, away, grip_of(rng))

    def act(self, machine: Machine) -> Act | None:
        """Pulls the grip by the tension at its end of the catenary; where the hose is nearly straight it stretches instead."""
        grip = Grip(machine, np.array(self.grip_m))
        fixed = grip.place() + np.array(self.anchor_from_home_m)
        bow = 1.0

        def hang(_: float) -> None:
            nonlocal bow
            place = grip.place()
            x, y, rise = (fixed - place).tolist()
            wide = max(math.hypot(x, y), 1e-3)
            length = max(self.length_m, TAUT * math.hypot(wide, rise))
            bow = bow_of(math.sqrt(length**2 - rise**2) / wide, bow)
            level = 0.5 * self.weight_n_per_m * wide / bow
            slope = math.sinh(math.atanh(rise / length) - bow)
            grip.push(place, level * np.array([x / wide, y / wide, slope]))

        return hang


CABLE: tuple[type[Fault], ...] = (
    SpringCable,
    SlackCable,
    TwistedHose,
    Reel,
    HangingHose,
)
