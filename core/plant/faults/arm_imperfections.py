"""What is never quite right of one arm and its sensor, whatever is planted besides: the same in each of its runs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.plant.arm import arm_of_cell
from core.plant.faults.draws import six
from core.plant.faults.encoders import EncoderOffsets
from core.plant.faults.fault import Fault, Setting
from core.plant.faults.joint_springs import ElasticJoints
from core.plant.faults.sensor_response import Gain

STIFFNESS_PER_RAD, STIFFEST = 1000.0, 5e4
"""Of a gear, times its torque limit, as harmonic drives of that size have; N m/rad that a period of 1 ms can still follow."""
SCATTER = 0.2
"""Of the logarithm of the stiffness."""


@dataclass(frozen=True)
class SmallZeros(EncoderOffsets):
    """Zeros of the encoders as a good calibration leaves them."""

    id = "none"
    variant = "small_zeros"

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Normal, 0.01 deg in each joint."""
        return cls(tuple((size * np.radians(0.01) * rng.standard_normal(setting.n)).tolist()))


@dataclass(frozen=True)
class StiffJoints(ElasticJoints):
    """Gears that give way as little as sound ones do. A spring that is planted takes their place."""

    id = "none"
    variant = "stiff_joints"

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """About 1000/rad of each joint's torque limit, at most 50 kN m/rad; a larger size is a softer arm."""
        stiffness = STIFFNESS_PER_RAD * arm_of_cell(setting.cell).effort * np.exp(SCATTER * rng.standard_normal(setting.n)) / size
        return cls(tuple(np.minimum(stiffness, STIFFEST).tolist()))


@dataclass(frozen=True)
class SmallGains(Gain):
    """Gains of the sensor as a good calibration leaves them."""

    id = "none"
    variant = "small_gains"

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Normal, 0.1 % in each channel."""
        return cls(six(size * 1e-3 * rng.standard_normal(6)))


ARM_IMPERFECTIONS: tuple[type[Fault], ...] = (SmallZeros, StiffJoints, SmallGains)


def draw_arm_imperfections(setting: Setting) -> tuple[Fault, ...]:
    """Those of the cell's own arm: drawn by its name alone."""
    rng = np.random.default_rng([*setting.cell.name.encode()])
    return tuple(fault.draw(rng, 1.0, setting) for fault in ARM_IMPERFECTIONS)
