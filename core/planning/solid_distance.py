"""Signed distances of points from the shapes that stand in a cell, compiled."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from core.array import Array
from core.payload.shapes import Box, Capsule, Cylinder, Pose, Shape, Sphere

BOX, CAPSULE, CYLINDER, POLYHEDRON = range(4)
"""A ball is a capsule without length; a polyhedron is convex, a half space the simplest."""
FACES_TURN_RAD = np.radians(20.0)
"""Between the planes that round off an edge: a distance from an edge is at most 1.5 % too small."""
DIRECTIONS = 200
"""In which planes touch the corners of a polyhedron."""


class Solids(NamedTuple):
    """Shapes as arrays.

    Args:
        kind: (S,).
        size: (S, 3), m; half sides of a box; radius and half length [r, 0, l] of a capsule, [r, inf, l] of a cylinder.
        R, p: (S, 3, 3) and (S, 3), their frames in the world.
        planes: (P, 4), of the polyhedra, one after the other: outward normals in their own frames, and distances from its origin, m.
        first: (S + 1,), where each shape's planes begin.
    """

    kind: NDArray[np.int64]
    size: Array
    R: Array
    p: Array
    planes: Array
    first: NDArray[np.int64]

    @classmethod
    def of(cls, solids: Sequence[Solid]) -> Solids:
        """Each of them."""
        counts = [len(solid.planes) for solid in solids]
        return cls(
            np.array([solid.kind for solid in solids], dtype=np.int64),
            np.array([solid.size for solid in solids], dtype=float).reshape(-1, 3),
            np.array([solid.R for solid in solids]).reshape(-1, 3, 3),
            np.array([solid.p for solid in solids]).reshape(-1, 3),
            np.concatenate([np.zeros((0, 4)), *(solid.planes for solid in solids)]),
            np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        )


class Solid(NamedTuple):
    """One shape of `Solids`, with the fields of that."""

    kind: int
    size: tuple[float, float, float]
    R: Array
    p: Array
    planes: Array = np.zeros((0, 4))


@njit(cache=True)
def signed_distance(solids: Solids, s: int, x: float, y: float, z: float) -> float:
    """Distance of a point of the world from shape s, m, negative inside; never too large, of a polyhedron a per cent or so too small."""
    R, p, size = solids.R[s], solids.p[s], solids.size[s]
    d0, d1, d2 = x - p[0], y - p[1], z - p[2]
    x = R[0, 0] * d0 + R[1, 0] * d1 + R[2, 0] * d2
    y = R[0, 1] * d0 + R[1, 1] * d1 + R[2, 1] * d2
    z = R[0, 2] * d0 + R[1, 2] * d1 + R[2, 2] * d2
    if solids.kind[s] == POLYHEDRON:
        farthest = -np.inf
        for k in range(solids.first[s], solids.first[s + 1]):
            n = solids.planes[k]
            farthest = max(farthest, n[0] * x + n[1] * y + n[2] * z - n[3])
        return float(farthest)
    if solids.kind[s] == CAPSULE:
        z -= min(max(z, -size[2]), size[2])
        return float(np.sqrt(x * x + y * y + z * z) - size[0])
    if solids.kind[s] == CYLINDER:  # a box of the plane through its axis and the point
        x, y = np.sqrt(x * x + y * y), 0.0
    x, y, z = abs(x) - size[0], abs(y) - size[1], abs(z) - size[2]
    outside = np.sqrt(max(x, 0.0) ** 2 + max(y, 0.0) ** 2 + max(z, 0.0) ** 2)
    return float(outside + min(max(x, y, z), 0.0))


def solid_of_shape(shape: Shape) -> Solid:
    """A shape where its pose says."""
    R, p = shape.pose.rotation, shape.pose.translation
    match shape:
        case Box():
            x, y, z = shape.size_m
            return Solid(BOX, (0.5 * x, 0.5 * y, 0.5 * z), R, p)
        case Capsule():
            return Solid(CAPSULE, (shape.radius_m, 0.0, 0.5 * shape.length_m), R, p)
        case Sphere():
            return Solid(CAPSULE, (shape.radius_m, 0.0, 0.0), R, p)
        case Cylinder():
            return Solid(CYLINDER, (shape.radius_m, np.inf, 0.5 * shape.length_m), R, p)


def solid_of_hull(points: Array, pose: Pose) -> Solid:
    """The convex hull of points (k, 3) in the frame of a pose.

    The distance from a convex body is the largest over all planes that touch it. Taken are those of its faces, some about each edge and
    some about its corners.
    """
    hull = ConvexHull(points)
    faces = hull.equations[:, :3]
    normals = [faces, _evenly(DIRECTIONS)]
    for face, beside in enumerate(hull.neighbors):
        normals += [_between(faces[face], faces[other]) for other in beside if other > face]
    n = np.unique(np.round(np.concatenate(normals), 9), axis=0)
    planes = np.column_stack([n, (n @ points.T).max(axis=1)])
    return Solid(POLYHEDRON, (0.0, 0.0, 0.0), pose.rotation, pose.translation, planes)


def _between(one: Array, other: Array) -> Array:
    """(k, 3), directions on the way from one to another, none farther than `FACES_TURN_RAD` from the next."""
    turn = float(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other))
    count = int(np.ceil(turn / FACES_TURN_RAD)) - 1
    if count < 1:
        return np.zeros((0, 3))
    share = np.arange(1, count + 1)[:, None] / (count + 1)
    return np.asarray((np.sin((1.0 - share) * turn) * one + np.sin(share * turn) * other) / np.sin(turn))


def _evenly(count: int) -> Array:
    """(count, 3), directions spread evenly over the sphere: a Fibonacci lattice (Gonzalez 2010)."""
    k = np.arange(count) + 0.5
    height, angle = 1.0 - 2.0 * k / count, np.pi * (1.0 + np.sqrt(5.0)) * k
    across = np.sqrt(1.0 - height**2)
    return np.column_stack([across * np.cos(angle), across * np.sin(angle), height])
