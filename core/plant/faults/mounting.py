"""The sensor is not mounted as drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.plant.faults.draws import direction, draw_log_uniform, sign, three
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Three
from core.plant.mechanics import to_mujoco_quaternion


def from_mujoco_quaternion(quat: Array) -> Array:
    """(3, 3) of a quaternion in MuJoCo's order."""
    return np.asarray(Rotation.from_quat(np.array(quat), scalar_first=True).as_matrix())


def turn_frame(quat: Array, rotvec: Array) -> Array:
    """A frame's quaternion after a further rotation about its own axes."""
    return to_mujoco_quaternion(from_mujoco_quaternion(quat) @ Rotation.from_rotvec(rotvec).as_matrix())


@dataclass(frozen=True)
class TurnedSensor(Fault):
    """The sensor is mounted turned by 0.3 to 3 deg; the payload hangs where it should."""

    id = "sensor_rotation"
    variant = "sensor_alone"

    rotation_rad: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 3 deg about any axis."""
        return cls(three(np.radians(size * draw_log_uniform(rng, 0.3, 3.0)) * direction(rng)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Turns the sensor's site in the payload's body by `rotation_rad`."""
        site = spec.site("ft")
        site.quat = turn_frame(site.quat, np.array(self.rotation_rad))


@dataclass(frozen=True)
class TurnedSensorWithPayload(TurnedSensor):
    """The sensor is mounted turned, and the payload with it."""

    variant = "with_payload"

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Turns the payload's body by `rotation_rad`, and with it the sensor's site."""
        body = spec.body("payload")
        body.quat = turn_frame(body.quat, np.array(self.rotation_rad))


@dataclass(frozen=True)
class ShiftedSensor(Fault):
    """The sensor's origin is 1 to 5 mm from where it should be; the payload hangs where it should."""

    id = "sensor_translation"
    variant = "sensor_alone"

    translation_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 mm in any direction."""
        return cls(three(size * draw_log_uniform(rng, 0.001, 0.005) * direction(rng)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Puts the sensor's site at `translation_m` in the payload's body."""
        spec.site("ft").pos = np.array(self.translation_m)


@dataclass(frozen=True)
class ShiftedSensorWithPayload(ShiftedSensor):
    """The sensor's origin is off, and the payload with it: only the motion tells."""

    variant = "with_payload"

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Shifts the payload's body by `translation_m` in its own axes, and with it the sensor's site."""
        body = spec.body("payload")
        body.pos = np.array(body.pos) + from_mujoco_quaternion(body.quat) @ np.array(self.translation_m)


@dataclass(frozen=True)
class LooseSensor(TurnedSensor):
    """The sensor is mounted turned, and its bolts have lost their grip: it rocks about one of its cross axes with the torque about it, to
    either side by `play`, nearly there at `seated`."""

    variant = "loose_bolts"

    play_rad: float
    axis: int
    seated_n_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 3 deg about any axis, play of 0.3 to 0.7 of it about x or y, seated at 10 to 50 % of the nominal torque."""
        angle = size * draw_log_uniform(rng, 0.3, 3.0)
        turn = three(np.radians(angle) * direction(rng))
        seated = rng.uniform(0.1, 0.5) * max(setting.load[3], 1e-3 * setting.full_scale[3])
        return cls(turn, float(np.radians(angle) * rng.uniform(0.3, 0.7)), int(rng.integers(2)), float(seated))

    def sense(self, machine: Machine) -> Channel | None:
        """Turns the axes of force and torque by `play tanh(torque / seated)` about the axis of the play."""
        a, b = (self.axis + 1) % 3, (self.axis + 2) % 3
        torque = 3 + self.axis

        def rock(_: float, W: Array) -> Array:
            angle = self.play_rad * math.tanh(float(W[torque]) / self.seated_n_m)
            c, s = math.cos(angle), math.sin(angle)
            felt = W.copy()
            for k in (0, 3):
                felt[a + k], felt[b + k] = c * W[a + k] + s * W[b + k], c * W[b + k] - s * W[a + k]
            return felt

        return rock


@dataclass(frozen=True)
class SplitOrigin(ShiftedSensor):
    """The sensor's origin is off, and is not one point: the torque about x is taken as far above it (`split`) as that about y below, as
    where the bridges of the two sit on beams of their own."""

    variant = "split"

    split_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 mm in any direction, and a split of 0.5 to 1 of it with either sign."""
        distance = size * draw_log_uniform(rng, 0.001, 0.005)
        return cls(three(distance * direction(rng)), float(sign(rng) * distance * rng.uniform(0.5, 1.0)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `split fy` to the torque about x and `split fx` to that about y."""
        split = np.zeros((6, 6))
        split[3, 1] = split[4, 0] = self.split_m
        return lambda _, W: W + split @ W


MOUNTING: tuple[type[Fault], ...] = (
    TurnedSensor,
    TurnedSensorWithPayload,
    ShiftedSensor,
    ShiftedSensorWithPayload,
    LooseSensor,
    SplitOrigin,
)
