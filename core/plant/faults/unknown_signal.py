"""What goes wrong in the sensor's signal and has no name in the table of effects."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import channels, direction, draw_log_uniform, draw_signed_log_uniform, seed_of, sign, six, three, wrench_of
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six, Three, Unknown
from core.plant.faults.switching import RandomSwitch


@dataclass(frozen=True)
class RubbingSeal(Unknown):
    """A seal round the sensor rubs: a torque about one axis, in proportion to the side load, against the last change of the axial force
    (Dahl's model with the axial force in place of the path)."""

    variant = "rubbing_seal"

    arm_m: float
    axis: int
    bend_n: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 10 mm with either sign, about any of the axes, turning within 0.3 to 3 N of axial force."""
        return cls(size * sign(rng) * draw_log_uniform(rng, 0.001, 0.01), int(rng.integers(3)), draw_log_uniform(rng, 0.3, 3.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `arm hypot(fx, fy) z` to one torque, z between -1 and 1 after the changes of fz."""
        last: float | None = None
        z = 0.0

        def rub(_: float, W: Array) -> Array:
            nonlocal last, z
            fx, fy, fz = W[:3].tolist()
            change = 0.0 if last is None else (fz - last) / self.bend_n
            last = fz
            z = min(max(z + change - abs(change) * z, -1.0), 1.0)
            W = W.copy()
            W[3 + self.axis] += self.arm_m * math.hypot(fx, fy) * z
            return W

        return rub


@dataclass(frozen=True)
class GainByJoint(Unknown):
    """The sensor's cable is bent by a joint: all gains change with its angle, `1 + e sin(k q + phase)`."""

    variant = "gain_by_joint"

    share: float
    joint: int
    waves_per_turn: int
    phase_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 %, one to three waves per turn of a joint in the outer half of the arm, any phase."""
        joint = int(rng.integers(setting.n // 2, setting.n))
        return cls(size * draw_log_uniform(rng, 0.01, 0.05), joint, int(rng.integers(1, 4)), float(rng.uniform(0, 2 * np.pi)))

    def sense(self, machine: Machine) -> Channel | None:
        """Multiplies the wrench by `1 + e sin(k q + phase)`."""
        data = machine.data
        place = int(np.arange(machine.model.nv)[machine.motors][self.joint])
        return lambda _, W: (1 + self.share * math.sin(self.waves_per_turn * data.qpos[place] + self.phase_rad)) * W


@dataclass(frozen=True)
class Telegraph(Unknown):
    """A loose contact: one channel jumps between two levels at random moments (a random telegraph)."""

    variant = "telegraph"

    level_wrench: Six
    mean_high_s: float
    mean_low_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 3 N with either sign in one channel, a torque by its range, 0.3 to 4 s at either level on average."""
        level = np.zeros(6)
        c = int(rng.integers(6))
        level[c] = sign(rng) * size * draw_log_uniform(rng, 0.3, 3.0) * setting.full_scale[c] / setting.full_scale[0]
        return cls(six(level), draw_log_uniform(rng, 0.3, 4.0), draw_log_uniform(rng, 0.3, 4.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds the level while a random switch is on; it is off at the start."""
        switch, level = RandomSwitch((self.mean_low_s, self.mean_high_s), self.seed, on=False), np.array(self.level_wrench)
        return lambda t, W: W + level if switch.is_on(t) else W


@dataclass(frozen=True)
class MagneticField(Unknown):
    """A magnet or a transformer in the cell disturbs the bridge: an offset that depends on where the sensor is, a bell round a place."""

    variant = "magnetic_field"

    peak_wrench: Six
    centre_from_home_m: Three
    width_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.5 to 4 N, with torques of the same share of their range, within 30 cm of home, 10 to 30 cm wide."""
        peak = wrench_of(rng, size * draw_log_uniform(rng, 0.5, 4.0), setting)
        return cls(peak, three(rng.uniform(0.0, 0.3) * direction(rng)), draw_log_uniform(rng, 0.1, 0.3))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `peak exp(-d^2 / (2 width^2))`, d from the sensor to the centre of the field."""
        data, body = machine.data, machine.body("payload")
        peak = np.array(self.peak_wrench)
        centre: Array | None = None

        def disturb(_: float, W: Array) -> Array:
            nonlocal centre
            place = data.xpos[body]
            if centre is None:
                centre = place + np.array(self.centre_from_home_m)
            away = place - centre
            return W + peak * math.exp(-0.5 * float(away @ away) / self.width_m**2)

        return disturb


@dataclass(frozen=True)
class MotorPickup(Unknown):
    """Motor currents couple into the sensor's bridge: channels show a share of one joint's torque."""

    variant = "motor_pickup"

    joint: int
    pickup_per_n_m: Six
    """N and N m per N m of the joint."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 mN per N m with either sign in one channel or several, torques by their range, of any joint but the first."""
        share = channels(rng) * draw_signed_log_uniform(rng, 0.005, 0.03, 6) * setting.full_scale / setting.full_scale[0]
        return cls(int(rng.integers(1, setting.n)), six(size * share))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `pickup` times the joint's torque."""
        data, pickup = machine.data, np.array(self.pickup_per_n_m)
        place = int(np.arange(machine.model.nv)[machine.motors][self.joint])
        return lambda _, W: W + pickup * data.qfrc_applied[place]


UNKNOWN_SIGNAL: tuple[type[Fault], ...] = (
    RubbingSeal,
    GainByJoint,
    Telegraph,
    MagneticField,
    MotorPickup,
)
