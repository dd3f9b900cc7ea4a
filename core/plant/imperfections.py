"""Imperfections that can be planted in the virtual robot. Plain data, all absent by default."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from core.array import Array

Six = tuple[float, float, float, float, float, float]


class Drift(Protocol):
    """A change of the wrist sensor's offset with time."""

    def offset(self, t: float) -> Array:
        """(6,), N and N m, at `t` seconds after the start; zero at `t = 0`."""
        ...


@dataclass(frozen=True)
class LinearOffsetDrift:
    """The offset grows steadily and reaches `size` (six values, N and N m) after `duration_s`."""

    size: Six
    duration_s: float

    def offset(self, t: float) -> Array:
        """(6,), N and N m."""
        return np.asarray(self.size) * (t / self.duration_s)


@dataclass(frozen=True)
class ExponentialOffsetDrift:
    """The offset settles at `size` (six values, N and N m) as of a sensor warming up: `size (1 - exp(-t /
    time_constant_s))`."""

    size: Six
    time_constant_s: float

    def offset(self, t: float) -> Array:
        """(6,), N and N m."""
        return np.asarray(self.size) * -math.expm1(-t / self.time_constant_s)


@dataclass(frozen=True)
class Imperfections:
    """What the virtual robot does not tell.

    Args:
        base_tilt_rad: x and y of the rotation vector, in the robot's base frame, by which true gravity is turned against
            the nominal one (z is zero). The base itself then stands turned by the opposite rotation.
        wrench_delay_s: the wrench of a sample is that of this much earlier; fractions of the control period are
            interpolated.
        offset_drift: changes of the wrench offset with time, added up.
    """

    base_tilt_rad: tuple[float, float] = (0.0, 0.0)
    wrench_delay_s: float = 0.0
    offset_drift: tuple[Drift, ...] = ()
