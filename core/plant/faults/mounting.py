"""Sensor, base or encoders do not stand as drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from core.plant.faults.draws import direction, scattered, seed_of, some_joints, spread, three
from core.plant.faults.fault import Act, Array, Fault, Joints, Machine, Setting, Three
from core.plant.mechanics import arm_joints, quaternion


def rotation_of(quat: Array) -> Array:
    """(3, 3) of a quaternion in MuJoCo's order."""
    return np.asarray(Rotation.from_quat(np.array(quat), scalar_first=True).as_matrix())


def turned(quat: Array, rotvec: Array) -> Array:
    """A frame's quaternion after a further rotation about its own axes."""
    return quaternion(rotation_of(quat) @ Rotation.from_rotvec(rotvec).as_matrix())


@dataclass(frozen=True)
class TurnedSensor(Fault):
    """The sensor is mounted turned by 0.3 to 3 deg; the payload hangs where it should."""

    id = "sensor_rotation"
    variant = "sensor_alone"

    rotation_rad: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(three(np.radians(size * spread(rng, 0.3, 3.0)) * direction(rng)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        site = spec.site("ft")
        site.quat = turned(site.quat, np.array(self.rotation_rad))


@dataclass(frozen=True)
class TurnedSensorWithPayload(TurnedSensor):
    """The sensor is mounted turned, and the payload with it."""

    variant = "with_payload"

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        body = spec.body("payload")
        body.quat = turned(body.quat, np.array(self.rotation_rad))


@dataclass(frozen=True)
class ShiftedSensor(Fault):
    """The sensor's origin is 1 to 5 mm from where it should be; the payload hangs where it should."""

    id = "sensor_translation"
    variant = "sensor_alone"

    translation_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(three(size * spread(rng, 0.001, 0.005) * direction(rng)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        spec.site("ft").pos = np.array(self.translation_m)


@dataclass(frozen=True)
class ShiftedSensorWithPayload(ShiftedSensor):
    """The sensor's origin is off, and the payload with it: only the motion tells."""

    variant = "with_payload"

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        body = spec.body("payload")
        body.pos = np.array(body.pos) + rotation_of(body.quat) @ np.array(self.translation_m)


def tilt_of(rng: np.random.Generator, degrees: float) -> tuple[float, float]:
    """x and y of a rotation vector in a direction that is all alike, rad."""
    angle = rng.uniform(0, 2 * np.pi)
    return float(np.radians(degrees) * np.cos(angle)), float(np.radians(degrees) * np.sin(angle))


def tilted(gravity: Array, setting: Setting, tilt_rad: tuple[float, float]) -> Array:
    """(3,), gravity in the world frame when it is turned by this rotation vector in the base frame."""
    base = setting.cell.robot.base.rotation
    tilt = Rotation.from_rotvec([*tilt_rad, 0.0]).as_matrix()
    return np.asarray(base @ tilt @ base.T @ gravity)


def leaning(gravity: Array, x: float, y: float) -> Array:
    """(3,), turned by a small rotation vector (x, y, 0), with its length kept."""
    gx, gy, gz = gravity.tolist()
    v = np.array([gx + y * gz, gy - x * gz, gz + x * gy - y * gx])
    return np.asarray(v * math.sqrt((gx * gx + gy * gy + gz * gz) / float(v @ v)))


@dataclass(frozen=True)
class TiltedBase(Fault):
    """The base is not level: gravity is turned in the base frame, by 0.1 to 3 deg."""

    id = "base_tilt"
    variant = "fixed"

    tilt_rad: tuple[float, float]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(tilt_of(rng, size * spread(rng, 0.1, 3.0)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        spec.option.gravity = tilted(np.array(spec.option.gravity), setting, self.tilt_rad)


@dataclass(frozen=True)
class SoftFloor(TiltedBase):
    """The base is not level, and the floor gives way under the moment of the arm's weight: the table of a mobile platform."""

    variant = "soft_floor"

    compliance_rad_per_n_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(tilt_of(rng, size * spread(rng, 0.1, 3.0)), size * spread(rng, 1e-5, 1e-4))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`. The base tips towards the arm's centre of mass as it would quasi-statically."""
        model, data, base = machine.model, machine.data, machine.setting.cell.robot.base
        R, origin = base.rotation, base.translation
        g0 = R.T @ model.opt.gravity
        yielding = self.compliance_rad_per_n_m * float(model.body_subtreemass[1])

        def sink(_: float) -> None:
            arm = R.T @ (data.subtree_com[1] - origin)
            # the base turns by c M with M = r x m g; seen from it, gravity turns back
            x = -yielding * (arm[1] * g0[2] - arm[2] * g0[1])
            y = -yielding * (arm[2] * g0[0] - arm[0] * g0[2])
            model.opt.gravity[:] = R @ leaning(g0, x, y)

        return sink


@dataclass(frozen=True)
class EncoderOffsets(Fault):
    """The zeros of one to three encoders are off by 0.1 to 2 deg: a joint stands farther by this than its encoder says."""

    id = "joint_offset"
    variant = "fixed"

    offset_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        offset = size * some_joints(rng, setting.n, 3) * np.radians(scattered(rng, 0.1, 2.0, setting.n))
        return cls(tuple(offset.tolist()))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        for joint, offset in zip(arm_joints(spec), self.offset_rad, strict=True):
            body = joint.parent
            body.quat = turned(body.quat, offset * np.array(joint.axis))


@dataclass(frozen=True)
class EccentricEncoders(EncoderOffsets):
    """Off by a constant and by as much once a turn: an encoder's disc that is not centred."""

    variant = "eccentric"

    seed: int = 0

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(EncoderOffsets.draw(rng, size, setting).offset_rad, seed_of(rng))

    def gear(self, machine: Machine) -> Joints | None:
        """See `Fault.gear`."""
        error = np.array(self.offset_rad)
        phase = np.random.default_rng(self.seed).uniform(0, 2 * np.pi, len(error))
        # q_encoder = q - e sin(q + phase): the joint is farther by this than the encoder says
        return lambda _, q, dq: (q - error * np.sin(q + phase), dq * (1 - error * np.cos(q + phase)))


MOUNTING: tuple[type[Fault], ...] = (
    TurnedSensor,
    TurnedSensorWithPayload,
    ShiftedSensor,
    ShiftedSensorWithPayload,
    TiltedBase,
    SoftFloor,
    EncoderOffsets,
    EccentricEncoders,
)
