"""Payloads and tools that are not rigid: parts on real joints of their own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.array import Array
from core.plant.faults.draws import direction, draw_log_uniform, three
from core.plant.faults.fault import Fault, Setting, Three
from core.plant.faults.parts import size_of, split_off
from core.plant.mechanics import get_parameters

HINGE, SLIDE, BALL = mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_BALL


def across(axis: Array) -> Array:
    """(3,), some unit vector normal to the axis."""
    other = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    return np.asarray(other / np.linalg.norm(other))


@dataclass(frozen=True)
class SprungPart(Fault):
    """A part of 5 to 30 % of the mass on a spring along one axis, 2.5 to 5 Hz: it sags with gravity and swings."""

    id = "payload_loose"
    variant = "spring_mass"

    part_share: float
    axis: Three
    frequency_hz: float
    damping_ratio: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 % of the mass, never more than 80 %, along any axis, 2.5 to 5 Hz, damping ratio 0.02 to 0.2."""
        share = min(size * draw_log_uniform(rng, 0.05, 0.3), 0.8)
        return cls(share, three(direction(rng)), draw_log_uniform(rng, 2.5, 5.0), draw_log_uniform(rng, 0.02, 0.2))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits the part off the payload and puts it on a slide with a spring and a damper."""
        part = split_off(spec, "payload:sprung", self.part_share)
        omega, mass = 2 * math.pi * self.frequency_hz, float(part.mass)
        damping = 2 * self.damping_ratio * omega * mass
        part.add_joint(name="payload:spring", type=SLIDE, axis=self.axis, stiffness=mass * omega**2, damping=damping)


@dataclass(frozen=True)
class Pendulum(Fault):
    """A part of the mass hangs from a point on the payload and swings in all directions; 1.2 to 3 Hz, so at most 17 cm long."""

    id = "payload_loose"
    variant = "pendulum"

    part_share: float
    length_m: float
    pivot_m: Three
    damping_ratio: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 % of the mass, at most 80 %, 1.2 to 3 Hz, damping ratio 0.02 to 0.2, pivot one radius of gyration off the centre."""
        omega = 2 * math.pi * draw_log_uniform(rng, 1.2, 3.0)
        payload = setting.payload
        pivot = payload.com + size_of(payload) * direction(rng)
        return cls(min(size * draw_log_uniform(rng, 0.05, 0.3), 0.8), 9.81 / omega**2, three(pivot), draw_log_uniform(rng, 0.02, 0.2))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits the part off the payload and hangs it on a damped ball joint, its centre of mass `length_m` from the pivot."""
        part = split_off(spec, "payload:pendulum", self.part_share, compactness=0.05)
        part.pos = np.array(self.pivot_m)
        part.ipos = np.array([0.0, 0.0, self.length_m])
        inertia = float(part.mass) * self.length_m**2 + float(np.max(part.inertia))
        damping = 2 * self.damping_ratio * math.sqrt(9.81 / self.length_m) * inertia
        part.add_joint(name="payload:ball", type=BALL, damping=damping)


@dataclass(frozen=True)
class Rattle(Fault):
    """A part slides in a slot with dry friction, from end stop to end stop, 2 to 15 mm to either side."""

    id = "payload_loose"
    variant = "end_stops"

    part_share: float
    axis: Three
    half_play_m: float
    friction_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 % of the mass, never more than 80 %, along any axis, 2 to 15 mm, friction of 5 to 30 % of the part's weight."""
        share = min(size * draw_log_uniform(rng, 0.05, 0.3), 0.8)
        return cls(share, three(direction(rng)), draw_log_uniform(rng, 0.002, 0.015), float(rng.uniform(0.05, 0.3)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits the part off the payload and puts it on a slide with dry friction and end stops."""
        part = split_off(spec, "payload:rattling", self.part_share)
        mass = float(part.mass)
        part.add_joint(
            name="payload:slot",
            type=SLIDE,
            axis=self.axis,
            damping=5.0 * mass,
            frictionloss=self.friction_share * 9.81 * mass,
            limited=True,
            range=[-self.half_play_m, self.half_play_m],
            solref_limit=[0.02, 0.7],
        )


@dataclass(frozen=True)
class WhippingTool(Fault):
    """All but a plate of `plate_share` hangs on hinges in a flexible adapter at the sensor's face: it nods about two axes across the
    lever, 10 to 40 Hz."""

    id = "tool_flexibility"
    variant = "hinges"

    plate_share: float
    pivot_m: Three
    frequency_hz: tuple[float, ...]
    damping_ratio: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 40 Hz, and 1.1 to 1.5 times as much about the other axis; a larger size is a softer tool, down to 4 Hz."""
        first = max(draw_log_uniform(rng, 10.0, 40.0) / math.sqrt(size), 4.0)
        # as far above the centre of mass as the payload is large: on the sensor's side
        com = setting.payload.com
        lever = com / np.linalg.norm(com) if np.linalg.norm(com) > 0 else np.array([0.0, 0.0, 1.0])
        pivot = com - max(float(np.linalg.norm(com)), 2 * size_of(setting.payload)) * lever
        plate = float(rng.uniform(0.05, 0.2))
        return cls(plate, three(pivot), (first, min(first * float(rng.uniform(1.1, 1.5)), 60.0)), draw_log_uniform(rng, 0.005, 0.05))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits all but the plate off and puts it on two sprung hinges at the pivot, across the lever."""
        part = split_off(spec, "payload:whipping", 1 - self.plate_share, compactness=1.0)
        pivot = np.array(self.pivot_m)
        lever = np.array(part.pos) - pivot
        part.pos, part.ipos = pivot, lever
        about_pivot = get_parameters(part).inertia
        first = across(lever)
        for k, axis in enumerate((first, np.cross(lever, first) / np.linalg.norm(lever))):
            J, omega = float(axis @ about_pivot @ axis), 2 * math.pi * self.frequency_hz[k]
            damping = 2 * self.damping_ratio * omega * J
            part.add_joint(name=f"payload:nod{k}", type=HINGE, axis=axis, stiffness=J * omega**2, damping=damping)


@dataclass(frozen=True)
class RubberTool(Fault):
    """All but a plate of `plate_share` sits on rubber that gives way along one axis, 10 to 40 Hz."""

    id = "tool_flexibility"
    variant = "slide"

    plate_share: float
    axis: Three
    frequency_hz: float
    damping_ratio: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 40 Hz along any axis, damping ratio 0.01 to 0.1; a larger size is a softer tool, down to 4 Hz."""
        frequency = max(draw_log_uniform(rng, 10.0, 40.0) / math.sqrt(size), 4.0)
        return cls(float(rng.uniform(0.05, 0.2)), three(direction(rng)), frequency, draw_log_uniform(rng, 0.01, 0.1))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits all but the plate off and puts it on a slide with a spring and a damper."""
        part = split_off(spec, "payload:rubber", 1 - self.plate_share, compactness=1.0)
        mass, omega = float(part.mass), 2 * math.pi * self.frequency_hz
        damping = 2 * self.damping_ratio * omega * mass
        part.add_joint(name="payload:rubber_slide", type=SLIDE, axis=self.axis, stiffness=mass * omega**2, damping=damping)


@dataclass(frozen=True)
class Slosh(Pendulum):
    """A part of the mass that swings in a vessel, as half-filled ones do: a pendulum that the walls stop at `half_angle` from the vessel's
    axis, so it lies at one of them where the vessel is tilted farther."""

    variant = "vessel"

    half_angle_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """A pendulum as `Pendulum` draws it, walls at 0.3 to 1 rad."""
        free = Pendulum.draw(rng, size, setting)
        return cls(free.part_share, free.length_m, free.pivot_m, free.damping_ratio, float(rng.uniform(0.3, 1.0)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Hangs the pendulum and stops it at `half_angle_rad`."""
        super().alter(spec, setting)
        ball = spec.joint("payload:ball")
        # MuJoCo's compiler takes angles in degrees
        ball.limited, ball.range, ball.solref_limit = True, [0.0, math.degrees(self.half_angle_rad)], [0.02, 0.7]


@dataclass(frozen=True)
class IdleRoller(Fault):
    """A roller or a spool that turns freely on the payload, and is heavier on one side: that side goes down as far as its bearing's dry
    friction lets it; nothing where its axis stands upright. At angle zero the payload is what it should be."""

    id = "payload_loose"
    variant = "roller"

    part_share: float
    axis: Three
    lever_m: Three
    """From the axis to the roller's centre of mass at angle zero."""
    friction_share: float
    damping_ratio: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 % of the mass, at most 80 %, any axis, 1.5 to 6 cm off it, friction of 5 to 25 %, damping ratio 0.02 to 0.2."""
        axis = direction(rng)
        turn, first = rng.uniform(0, 2 * np.pi), across(axis)
        lever = draw_log_uniform(rng, 0.015, 0.06) * (np.cos(turn) * first + np.sin(turn) * np.cross(axis, first))
        share = min(size * draw_log_uniform(rng, 0.05, 0.3), 0.8)
        return cls(share, three(axis), three(lever), float(rng.uniform(0.05, 0.25)), draw_log_uniform(rng, 0.02, 0.2))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Splits the roller off the payload and puts it on a hinge with dry and viscous friction."""
        part = split_off(spec, "payload:roller", self.part_share)
        lever, axis = np.array(self.lever_m), np.array(self.axis)
        part.pos, part.ipos = np.array(part.pos) - lever, lever
        weight_torque = 9.81 * float(part.mass) * float(np.linalg.norm(lever))
        inertia = float(axis @ get_parameters(part).inertia @ axis)
        part.add_joint(
            name="payload:bearing",
            type=HINGE,
            axis=self.axis,
            damping=2 * self.damping_ratio * math.sqrt(weight_torque * inertia),
            frictionloss=self.friction_share * weight_torque,
        )


LOOSE: tuple[type[Fault], ...] = (
    SprungPart,
    Pendulum,
    Rattle,
    WhippingTool,
    RubberTool,
    Slosh,
    IdleRoller,
)
