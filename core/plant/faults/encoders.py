"""The zeros of the encoders are off."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.plant.faults.draws import draw_log_uniform, draw_signed_log_uniform, seed_of, some_joints
from core.plant.faults.fault import Fault, Joints, Machine, Setting
from core.plant.faults.mounting import turn_frame
from core.plant.mechanics import arm_joints


@dataclass(frozen=True)
class EncoderOffsets(Fault):
    """The zeros of one to three encoders are off by 0.1 to 2 deg: a joint stands farther by this than its encoder says."""

    id = "joint_offset"
    variant = "fixed"

    offset_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.1 to 2 deg with either sign in one to three joints."""
        offset = size * some_joints(rng, setting.n, 3) * np.radians(draw_signed_log_uniform(rng, 0.1, 2.0, setting.n))
        return cls(tuple(offset.tolist()))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Turns the body of each joint by its offset about the joint's axis."""
        for joint, offset in zip(arm_joints(spec), self.offset_rad, strict=True):
            body = joint.parent
            body.quat = turn_frame(body.quat, offset * np.array(joint.axis))


@dataclass(frozen=True)
class EccentricEncoders(EncoderOffsets):
    """Off by a constant and by as much once a turn: an encoder's disc that is not centred."""

    variant = "eccentric"

    seed: int = 0

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Offsets as `EncoderOffsets` draws them, and a seed for the phases."""
        return cls(EncoderOffsets.draw(rng, size, setting).offset_rad, seed_of(rng))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows `q - e sin(q + phase)` and its rate, with phases that `seed` fixes."""
        error = np.array(self.offset_rad)
        phase = np.random.default_rng(self.seed).uniform(0, 2 * np.pi, len(error))
        # q_encoder = q - e sin(q + phase): the joint is farther by this than the encoder says
        return lambda _, q, dq: (q - error * np.sin(q + phase), dq * (1 - error * np.cos(q + phase)))


@dataclass(frozen=True)
class WarmingArm(EncoderOffsets):
    """Off by a constant, and by more as the arm warms up: another `growth` of it, exponentially."""

    variant = "warming"

    growth_share: float
    time_constant_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Offsets as `EncoderOffsets` draws them, growth of 0.4 to 1 of them, time constant of 0.2 to 1 of the run."""
        offset = EncoderOffsets.draw(rng, size, setting).offset_rad
        return cls(offset, float(rng.uniform(0.4, 1.0)), setting.seconds * draw_log_uniform(rng, 0.2, 1.0))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows `q - growth (1 - exp(-t / tau))` and its rate."""
        grown, tau = self.growth_share * np.array(self.offset_rad), self.time_constant_s
        return lambda t, q, dq: (q + grown * math.expm1(-t / tau), dq - grown / tau * math.exp(-t / tau))


ENCODERS: tuple[type[Fault], ...] = (
    EncoderOffsets,
    EccentricEncoders,
    WarmingArm,
)
