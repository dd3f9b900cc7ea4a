"""Principal moments and axes of an inertia, and the ways in which controllers write a rotation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.payload.inertia import symmetric


@dataclass(frozen=True)
class PrincipalAxes:
    """`inertia = rotation diag(moments) rotation^T`.

    Args:
        moments: (3,), kg m2.
        rotation: (3, 3), its columns are the axes, right-handed. Of the 24 ways to name them it is the one that turns least.
    """

    moments: Array
    rotation: Array


def principal_axes(inertia: Array) -> PrincipalAxes:
    """Of `[Ixx, Ixy, Ixz, Iyy, Iyz, Izz]`."""
    moments, axes = np.linalg.eigh(symmetric(inertia))
    order = _nearest_order(axes)
    moments, axes = moments[order], axes[:, order]
    axes = axes * np.where(np.diag(axes) < 0.0, -1.0, 1.0)
    if np.linalg.det(axes) < 0.0:
        axes[:, np.argmin(np.abs(np.diag(axes)))] *= -1.0
    return PrincipalAxes(moments, axes)


def _nearest_order(axes: Array) -> list[int]:
    """Which principal axis is called x, y and z: each frame axis takes, in turn of clearness, the one that is nearest to it."""
    left, order = np.abs(axes), [0, 0, 0]
    for _ in range(3):
        row, column = np.unravel_index(np.argmax(left), left.shape)
        order[row] = int(column)
        left[row, :] = left[:, column] = -1.0
    return order


def zyx_degrees(rotation: Array) -> Array:
    """(3,), A, B, C in degrees with `rotation = Rz(A) Ry(B) Rx(C)`, as KUKA and OPC UA for Robotics turn.

    One of A and C is 0 where B is a right angle: both turn about the same axis there.
    """
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - the service knows the exports, and starts without SciPy

    return np.asarray(Rotation.from_matrix(rotation).as_euler("ZYX", degrees=True, suppress_warnings=True))


def to_quaternion(rotation: Array) -> Array:
    """(4,), w x y z with w >= 0."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - as above

    return np.asarray(Rotation.from_matrix(rotation).as_quat(canonical=True, scalar_first=True))
