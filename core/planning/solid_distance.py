"""Signed distances of points from the shapes that stand in a cell, compiled."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.payload.shapes import Box, Capsule, Cylinder, Shape, Sphere


class Solids(NamedTuple):
    """Shapes as arrays.

    Args:
        kind: (S,), 0 box, 1 capsule or ball, 2 cylinder.
        size: (S, 3), m, as `solid_distance` takes it.
        R, p: (S, 3, 3) and (S, 3), their frames in the world.
    """

    kind: NDArray[np.int64]
    size: Array
    R: Array
    p: Array

    @classmethod
    def of(cls, shapes: Sequence[Shape]) -> Solids:
        """Shapes where their poses say."""
        solids = [_solid(shape) for shape in shapes]
        return cls(
            np.array([kind for kind, _ in solids], dtype=np.int64),
            np.array([size for _, size in solids]).reshape(-1, 3),
            np.array([shape.pose.rotation for shape in shapes]).reshape(-1, 3, 3),
            np.array([shape.pose.translation for shape in shapes]).reshape(-1, 3),
        )


@njit(cache=True)
def solid_distance(kind: int, size: Array, x: float, y: float, z: float) -> float:
    """Signed distance of a point in a shape's own frame.

    0 box with half sides `size`; 1 capsule, 2 cylinder, both of radius size[0] and half length size[2], the cylinder with size[1] infinite.
    """
    if kind == 1:
        z -= min(max(z, -size[2]), size[2])
        return float(np.sqrt(x * x + y * y + z * z) - size[0])
    if kind == 2:  # a box of the plane through its axis and the point
        x, y = np.sqrt(x * x + y * y), 0.0
    dx, dy, dz = abs(x) - size[0], abs(y) - size[1], abs(z) - size[2]
    outside = np.sqrt(max(dx, 0.0) ** 2 + max(dy, 0.0) ** 2 + max(dz, 0.0) ** 2)
    return float(outside + min(max(dx, dy, dz), 0.0))


def _solid(shape: Shape) -> tuple[int, tuple[float, float, float]]:
    """Kind and size."""
    match shape:
        case Box():
            x, y, z = shape.size_m
            return 0, (0.5 * x, 0.5 * y, 0.5 * z)
        case Capsule():
            return 1, (shape.radius_m, 0.0, 0.5 * shape.length_m)
        case Sphere():
            return 1, (shape.radius_m, 0.0, 0.0)
        case Cylinder():
            return 2, (shape.radius_m, np.inf, 0.5 * shape.length_m)
