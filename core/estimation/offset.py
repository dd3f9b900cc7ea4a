"""Offsets of the sensor from opposed poses, Eq. (5)."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.estimation.segments import ALONG_AXIS


def pose_of_gravity(g: Array) -> tuple[int, int] | None:
    """Sensor axis (0, 1, 2) and sign (+1 along gravity, -1 against) that gravity (3,), sensor frame, lies along; None if none does."""
    axis = int(np.argmax(np.abs(g)))
    if abs(g[axis]) < ALONG_AXIS * float(np.sqrt(g @ g)):
        return None
    return axis, 1 if g[axis] > 0 else -1


class OpposedPoses:
    """Running means of the raw wrench with each sensor axis along and against gravity."""

    def __init__(self) -> None:
        self._sum = np.zeros((3, 2, 2))
        self._count = np.zeros((3, 2), dtype=int)

    def add(self, g: Array, wrench: Array) -> None:
        """Takes one motionless sample: gravity (3,) in the sensor frame and the raw wrench (6,)."""
        pose = pose_of_gravity(g)
        if pose is not None:
            axis, sign = pose
            side = 0 if sign > 0 else 1
            self._sum[axis, side] += wrench[axis], wrench[3 + axis]
            self._count[axis, side] += 1

    @property
    def offset(self) -> Array:
        """(6,), Eq. (5); NaN for an axis that was not seen both ways."""
        offset = np.full(6, np.nan)
        for axis in range(3):
            if self._count[axis].all():
                mean = self._sum[axis] / self._count[axis][:, None]
                offset[axis], offset[3 + axis] = mean.mean(axis=0)
        return offset


def offset_of_opposed_poses(g: Array, wrench: Array) -> Array:
    """Eq. (5) for motionless samples at once: g (N, 3), raw wrench (N, 6) -> (6,), NaN for an axis that was not seen both ways."""
    offset = np.full(6, np.nan)
    direction = g / np.linalg.norm(g, axis=1, keepdims=True)
    for axis in range(3):
        along, against = direction[:, axis] > ALONG_AXIS, direction[:, axis] < -ALONG_AXIS
        if along.any() and against.any():
            for channel in (axis, 3 + axis):
                offset[channel] = 0.5 * (wrench[along, channel].mean() + wrench[against, channel].mean())
    return offset
