"""The payload is not what it should be, does not stay so, or is not rigid."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.array import Array
from core.payload.inertia import InertialParameters
from core.plant.faults.draws import direction, draw_log_uniform, draw_signed_log_uniform, moment, sign, three
from core.plant.faults.fault import Act, Fault, Machine, Setting, Three
from core.plant.faults.parts import scale_mass, size_of, split_off
from core.plant.mechanics import get_parameters, set_parameters


@dataclass(frozen=True)
class OtherDensity(Fault):
    """The payload has the reference's shape but another mass, and its centre of mass and inertia are off by as much: 2 to 20 %."""

    id = "payload_mismatch"
    variant = "scaled"

    mass_share: float
    com_m: Three
    inertia_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Mass and inertia off by 2 to 20 % with either sign, the centre of mass by 2 to 20 % of the radius of gyration."""
        mass, inertia = size * draw_signed_log_uniform(rng, 0.02, 0.2, 2)
        shift = size * draw_log_uniform(rng, 0.02, 0.2) * size_of(setting.payload) * direction(rng)
        return cls(max(float(mass), -0.8), three(shift), max(float(inertia), -0.8))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Scales mass and inertia of the payload's body and shifts its centre of mass."""
        body = spec.body("payload")
        body.mass *= 1 + self.mass_share
        body.inertia = (1 + self.mass_share) * (1 + self.inertia_share) * np.array(body.inertia)
        body.ipos = np.array(body.ipos) + np.array(self.com_m)


@dataclass(frozen=True)
class ForgottenPart(Fault):
    """An adapter or workpiece that the reference does not know sits on the payload: a ball of steel."""

    id = "payload_mismatch"
    variant = "extra_part"

    mass_kg: float
    at_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """2 to 20 % of the payload's mass, two radii of gyration from its centre of mass."""
        payload = setting.payload
        at = payload.com + 2 * size_of(payload) * direction(rng)
        return cls(size * draw_log_uniform(rng, 0.02, 0.2) * payload.mass, three(at))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Adds the ball's inertial parameters to those of the payload's body."""
        body = spec.body("payload")
        part = ball(self.mass_kg, np.array(self.at_m))
        set_parameters(body, InertialParameters(get_parameters(body).phi + part.phi))


def ball(mass_kg: float, at: Array) -> InertialParameters:
    """Of steel, 7850 kg/m3."""
    radius = (mass_kg / 7850 * 3 / (4 * math.pi)) ** (1 / 3)
    return InertialParameters.from_com(mass_kg, at, 0.4 * mass_kg * radius**2 * np.eye(3))


@dataclass(frozen=True)
class Slip(Fault):
    """A part of the payload slips once by 2 to 40 mm, within `slide` seconds."""

    id = "payload_shift"
    variant = "step"

    part_share: float
    shift_m: Three
    at_s: float
    slide_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 40 % of the payload, 2 to 40 mm in any direction, at a time well inside the run."""
        shift = size * draw_log_uniform(rng, 0.002, 0.04) * direction(rng)
        return cls(float(rng.uniform(0.1, 0.4)), three(shift), moment(rng, setting), cls._slide(rng))

    @staticmethod
    def _slide(_: np.random.Generator) -> float:
        return 0.0

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits the part that will slip off the payload."""
        split_off(spec, "payload:slipping", self.part_share)

    def act(self, machine: Machine) -> Act | None:
        """Moves the part by `shift_m` from `at_s` on, at once or evenly over `slide_s`."""
        model, body = machine.model, machine.body("payload:slipping")
        start, shift = model.body_pos[body].copy(), np.array(self.shift_m)

        def slip(t: float) -> None:
            gone = 1.0 if self.slide_s == 0 else min((t - self.at_s) / self.slide_s, 1.0)
            if t >= self.at_s:
                model.body_pos[body] = start + gone * shift

        return slip


@dataclass(frozen=True)
class Slide(Slip):
    """Slips slowly, over seconds: a belt or a suction cup that gives way."""

    variant = "slow"

    @staticmethod
    def _slide(rng: np.random.Generator) -> float:
        return draw_log_uniform(rng, 1.0, 8.0)


@dataclass(frozen=True)
class MassStep(Fault):
    """A part of 20 to 300 g comes off, or is taken up, at once."""

    id = "payload_mass_change"
    variant = "step"

    change_kg: float
    at_m: Three
    begin_s: float
    duration_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """20 to 300 g more or less, 1.5 radii of gyration from the centre of mass. Of what there is, not more than half comes off."""
        payload = setting.payload
        change = size * draw_log_uniform(rng, 0.02, 0.3) * sign(rng)
        at = payload.com + 1.5 * size_of(payload) * direction(rng)
        return cls(max(change, -0.5 * payload.mass), three(at), *cls._window(rng, setting))

    @staticmethod
    def _window(rng: np.random.Generator, setting: Setting) -> tuple[float, float]:
        return moment(rng, setting), 0.0

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Adds a body for what changes. What will come off is a part of the payload from the start."""
        body = spec.body("payload")
        size = abs(self.change_kg)
        part = body.add_body(name="payload:changing", pos=np.array(self.at_m))
        set_parameters(part, ball(size, np.zeros(3)))
        if self.change_kg < 0:
            share = size / float(body.mass)
            centre = np.array(body.ipos)
            set_parameters(body, scale_mass(get_parameters(body), 1 - share))
            # together they are what the payload was, to the first moment
            body.ipos = (centre - share * np.array(self.at_m)) / (1 - share)

    def act(self, machine: Machine) -> Act | None:
        """Brings mass and inertia of the part in or out from `begin_s` on, at once or evenly over `duration_s`."""
        model, body = machine.model, machine.body("payload:changing")
        mass, inertia = float(model.body_mass[body]), model.body_inertia[body].copy()
        gains = self.change_kg > 0

        def change(t: float) -> None:
            elapsed = t - self.begin_s
            done = 0.0 if elapsed < 0 else 1.0 if elapsed >= self.duration_s else elapsed / self.duration_s
            there = done if gains else 1 - done
            model.body_mass[body] = there * mass
            model.body_inertia[body] = there * inertia

        return change


@dataclass(frozen=True)
class Leak(MassStep):
    """The same amount trickles out or in over a third of the run."""

    variant = "leak"

    @staticmethod
    def _window(rng: np.random.Generator, setting: Setting) -> tuple[float, float]:
        return float(rng.uniform(0.1, 0.5) * setting.seconds), float(rng.uniform(0.2, 0.5) * setting.seconds)


PAYLOAD: tuple[type[Fault], ...] = (OtherDensity, ForgottenPart, Slip, Slide, MassStep, Leak)
