"""Convex solids for python-fcl, each as a polyhedron and a radius round it, and distances that are certified.

python-fcl puts round shapes up to some millimetres farther away than they are. A ball is therefore a point with a radius, a capsule a line
with a radius, and a cylinder a prism that contains it. Boxes that are nearly parallel it now and then (some in ten thousand) puts too far
away as well, by centimetres at worst: each of its answers is held against the gap along its own direction, which no two convex bodies can
be nearer than, and where the two differ the least distance is found from the corners.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import fcl
import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.optimize import nnls
from scipy.spatial import ConvexHull

from core.cell import Box, Capsule, Shape, Sphere
from core.errors import BadRobot

Array = NDArray[np.float64]

SIDES = 64
"""Of the prism round a cylinder: its edges stand out by 0.12 % of the radius."""

CERTAIN_M = 1e-7
"""How far python-fcl's answer may be from what its direction proves."""

_REQUEST = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=True)


@dataclass(frozen=True)
class Solid:
    """All points at most `radius_m` from a convex core.

    Args:
        core: python-fcl's geometry, about the solid's own origin.
        points: (k, 3), corners of the core, in the same frame, m.
        corners: (8, 3), corners of a box round the solid, in its own frame, m.
    """

    core: Any
    points: Array
    radius_m: float
    corners: Array


class PlacedSolid(NamedTuple):
    """A solid somewhere in the world.

    Args:
        core: python-fcl's object.
        points: (k, 3), corners of the solid's core in the world, m.
    """

    solid: Solid
    core: Any
    points: Array


def box(size: Array) -> Solid:
    """A cuboid of that size (3,) about its origin, m."""
    corners = _corners(-0.5 * size, 0.5 * size)
    return Solid(fcl.Box(*size), corners, 0.0, corners)


def ball(radius: float) -> Solid:
    """About its origin, m."""
    return Solid(fcl.Box(0.0, 0.0, 0.0), np.zeros((1, 3)), radius, _corners(np.full(3, -radius), np.full(3, radius)))


def capsule(radius: float, length: float) -> Solid:
    """Along z; `length` without the round ends, m."""
    ends = np.array([[0.0, 0.0, -0.5 * length], [0.0, 0.0, 0.5 * length]])
    return Solid(fcl.Box(0.0, 0.0, length), ends, radius, _corners(ends[0] - radius, ends[1] + radius))


def cylinder(radius: float, length: float) -> Solid:
    """Along z: the prism round it, m."""
    angle = 2.0 * np.pi * np.arange(SIDES) / SIDES
    ring = radius / np.cos(np.pi / SIDES) * np.column_stack([np.cos(angle), np.sin(angle)])
    points = np.vstack([np.column_stack([ring, np.full(SIDES, z)]) for z in (-0.5 * length, 0.5 * length)])
    return hull(points)


def hull(points: Array) -> Solid:
    """The convex hull of points (k, 3), m."""
    found = ConvexHull(points)
    number = {int(k): i for i, k in enumerate(found.vertices)}
    faces: list[int] = []
    for corners, equation in zip(found.simplices, found.equations, strict=True):
        a, b, c = points[corners]
        outward = np.cross(b - a, c - a) @ equation[:3] > 0.0
        faces += [3, *(number[int(k)] for k in (corners if outward else corners[::-1]))]
    core = fcl.Convex(points[found.vertices], len(found.simplices), np.array(faces))
    return Solid(core, points[found.vertices], 0.0, _corners(points.min(axis=0), points.max(axis=0)))


def solid_of_shape(shape: Shape) -> Solid:
    """Of an obstacle, a zone or a payload box, about its own origin."""
    match shape:
        case Box():
            return box(np.array(shape.size_m))
        case Sphere():
            return ball(shape.radius_m)
        case Capsule():
            return capsule(shape.radius_m, shape.length_m)


def solid_of_geometry(geometry: ET.Element, folder: Path) -> Solid:
    """Of a URDF's checked `geometry` element; a mesh, in that folder, as its convex hull.

    Raises:
        BadRobot: a mesh in a format that cannot be read here.
    """
    shape = geometry[0]
    match shape.tag:
        case "box":
            return box(numbers(shape.get("size", "")))
        case "sphere":
            return ball(float(shape.get("radius", "")))
        case "capsule":
            return capsule(float(shape.get("radius", "")), float(shape.get("length", "")))
        case "cylinder":
            return cylinder(float(shape.get("radius", "")), float(shape.get("length", "")))
    return hull(_mesh_points(folder / shape.get("filename", "")) * numbers(shape.get("scale", "1 1 1")))


def place(solid: Solid, rotation: Array, position: Array) -> PlacedSolid:
    """A solid with its origin at `position` (3,), turned by `rotation` (3, 3)."""
    core = fcl.CollisionObject(solid.core, fcl.Transform(rotation, position))
    return PlacedSolid(solid, core, solid.points @ rotation.T + position)


def distance(first: PlacedSolid, second: PlacedSolid) -> float:
    """Signed distance, negative where they penetrate, m; never more than `CERTAIN_M` too far."""
    found = fcl.DistanceResult()
    between_cores = float(fcl.distance(first.core, second.core, _REQUEST, found))
    if between_cores > CERTAIN_M:
        a, b = first.points, second.points
        if between_cores - _gap(a, b, np.subtract(*reversed(found.nearest_points))) > CERTAIN_M:
            between_cores = max(0.0, _gap(a, b, _shortest(a, b)))
    return between_cores - first.solid.radius_m - second.solid.radius_m


def _gap(a: Array, b: Array, direction: Array) -> float:
    """How far hulls of points are apart along a direction (3,) from a to b: never more than their distance."""
    length = np.sqrt(direction @ direction)
    return float(((b @ direction).min() - (a @ direction).max()) / length) if length > 0.0 else 0.0


def _shortest(a: Array, b: Array) -> Array:
    """(3,), the shortest way from the hull of points a (k, 3) to that of b: least squares with weights that are not negative.

    That the weights of each hull add up to one is asked for with a large factor.
    """
    factor = 1e4
    sums = np.zeros((2, len(a) + len(b)))
    sums[0, : len(a)] = sums[1, len(a) :] = factor
    weights, _ = nnls(np.vstack([np.hstack([-a.T, b.T]), sums]), np.array([0.0, 0.0, 0.0, factor, factor]))
    of_a, of_b = weights[: len(a)], weights[len(a) :]
    return np.asarray(of_b @ b / of_b.sum() - of_a @ a / of_a.sum())


def numbers(text: str) -> Array:
    """The numbers of a URDF's attribute."""
    return np.array([float(word) for word in text.split()])


def _mesh_points(file: Path) -> Array:
    """(k, 3), vertices of a mesh."""
    try:
        return np.asarray(trimesh.load_mesh(file).vertices, dtype=float)
    except (ValueError, NotImplementedError, ImportError, AttributeError) as error:
        raise BadRobot(f"{file}", f"a mesh that the second opinion on plans cannot read ({error})", "an STL or OBJ file") from error


def _corners(low: Array, high: Array) -> Array:
    return np.stack(np.meshgrid(*np.array([low, high]).T), axis=-1).reshape(-1, 3)
