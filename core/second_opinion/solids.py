"""Convex solids for python-fcl, each as a polyhedron and a radius round it, and distances that are certified.

python-fcl puts round shapes up to some millimetres farther away than they are. A ball is therefore a point with a radius, a capsule a line
with a radius, and a cylinder a prism that contains it. Boxes that are nearly parallel it now and then (some in ten thousand) puts too far
away as well, by centimetres at worst: each of its answers is held against the gap along its own direction, which no two convex bodies can
be nearer than, and where the two differ the least distance is found from the corners.

A mesh that is not convex keeps its triangles beside its hull, and counts with them where hulls come near each other: outside with its exact
distance, and as deep as the hulls where the surfaces meet.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import fcl
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls
from scipy.spatial import ConvexHull, QhullError

from core.array import Array
from core.cell.cell import Box, Capsule, Cell, Cylinder, Mesh, Shape, Sphere
from core.second_opinion.surfaces import Surface, read_surfaces, winding_number

SIDES = 64
"""Of the prism round a cylinder: its edges stand out by 0.12 % of the radius."""

CERTAIN_M = 1e-7
"""How far python-fcl's answer may be from what its direction proves."""

NEAR_M = 0.05
"""Solids with hulls farther apart are as far as their hulls, or farther."""

_REQUEST = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=True)


@dataclass(frozen=True)
class Solid:
    """All points at most `radius_m` from a core, convex or within a surface.

    Args:
        core: python-fcl's geometry of the core or of its hull, about the solid's own origin.
        points: (k, 3), corners of the core, in the same frame, m.
        corners: (8, 3), corners of a box round the solid, in its own frame, m.
        surface: of a core that is not convex.
    """

    core: Any
    points: Array
    radius_m: float
    corners: Array
    surface: Surface | None = None

    @cached_property
    def boundary(self) -> Surface:
        """The surface, or that of the convex core; of a line or a point a triangle without room."""
        if self.surface is not None:
            return self.surface
        try:
            return Surface(self.points, _outward_faces(self.points))
        except (QhullError, ValueError):
            return Surface(self.points, np.array([[0, len(self.points) - 1, len(self.points) - 1]]))


class PlacedSolid(NamedTuple):
    """A solid somewhere in the world.

    Args:
        core: python-fcl's object.
        points: (k, 3), corners of the solid's core in the world, m.
        rotation, position: (3, 3) and (3,), of its frame in the world.
    """

    solid: Solid
    core: Any
    points: Array
    rotation: Array
    position: Array


def box(size: Array) -> Solid:
    """A cuboid of that size (3,) about its origin, m."""
    corners = _corners(-0.5 * size, 0.5 * size)
    return Solid(fcl.Box(*size), corners, 0.0, corners)


def sphere(radius: float) -> Solid:
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
    used = np.unique(ConvexHull(points).vertices)
    corners = points[used]
    faces = _outward_faces(corners)
    core = fcl.Convex(corners, len(faces), np.column_stack([np.full(len(faces), 3), faces]).ravel())
    return Solid(core, corners, 0.0, _corners(points.min(axis=0), points.max(axis=0)))


def _outward_faces(points: Array) -> NDArray[np.int64]:
    """(m, 3), triangles of the convex hull of points (k, 3), counter-clockwise seen from outside."""
    found = ConvexHull(points)
    a, b, c = np.moveaxis(points[found.simplices], 1, 0)
    outward = np.einsum("mi,mi->m", np.cross(b - a, c - a), found.equations[:, :3]) > 0.0
    return np.where(outward[:, None], found.simplices, found.simplices[:, ::-1]).astype(np.int64)


def solid_of_shape(shape: Shape) -> Solid:
    """Of an obstacle, a zone or a payload box, about its own origin."""
    match shape:
        case Box():
            return box(np.array(shape.size_m))
        case Sphere():
            return sphere(shape.radius_m)
        case Capsule():
            return capsule(shape.radius_m, shape.length_m)
        case Cylinder():
            return cylinder(shape.radius_m, shape.length_m)


def solids_of_geometries(geometries: Sequence[ET.Element], folder: Path) -> list[Solid]:
    """Of a URDF's checked `geometry` elements; meshes are in that folder.

    Raises:
        BadRobot: a mesh that cannot be read here.
    """
    meshes = [geometry[0] for geometry in geometries if geometry[0].tag == "mesh"]
    scales = [parse_vector(mesh.get("scale", "1 1 1")) for mesh in meshes]
    surfaces = iter(read_surfaces([folder / mesh.get("filename", "") for mesh in meshes], scales))
    return [_of_surface(next(surfaces)) if geometry[0].tag == "mesh" else _primitive(geometry[0]) for geometry in geometries]


def solids_of_standing(cell: Cell) -> list[Solid]:
    """Of obstacles, then zones, each about its own origin, a mesh about that of its file.

    Raises:
        BadRobot: a mesh that cannot be read here.
    """
    meshes = [item.shape for item in cell.standing if isinstance(item.shape, Mesh)]
    surfaces = iter(read_surfaces([cell.folder / mesh.file for mesh in meshes], [np.array(mesh.scale) for mesh in meshes]))
    shapes = [item.shape for item in cell.standing]
    return [_of_surface(next(surfaces)) if isinstance(shape, Mesh) else solid_of_shape(shape) for shape in shapes]


def _of_surface(surface: Surface) -> Solid:
    around = hull(surface.vertices)
    return around if surface.is_convex else replace(around, surface=surface)


def _primitive(shape: ET.Element) -> Solid:
    match shape.tag:
        case "box":
            return box(parse_vector(shape.get("size", "")))
        case "sphere":
            return sphere(float(shape.get("radius", "")))
        case "capsule":
            return capsule(float(shape.get("radius", "")), float(shape.get("length", "")))
    return cylinder(float(shape.get("radius", "")), float(shape.get("length", "")))


def place(solid: Solid, rotation: Array, position: Array) -> PlacedSolid:
    """A solid with its origin at `position` (3,), turned by `rotation` (3, 3)."""
    core = fcl.CollisionObject(solid.core, fcl.Transform(rotation, position))
    return PlacedSolid(solid, core, solid.points @ rotation.T + position, rotation, position)


def distance(first: PlacedSolid, second: PlacedSolid) -> float:
    """Signed distance, negative where they penetrate, m.

    Of convex solids never more than `CERTAIN_M` too far. Of others exact where their hulls are less than `NEAR_M` apart, else at most the
    exact one; where they penetrate, that of the hulls.
    """
    between_cores = _between_hulls(first, second)
    if between_cores < NEAR_M and (first.solid.surface is not None or second.solid.surface is not None):
        between_cores = _between_surfaces(first, second, between_cores)
    return between_cores - first.solid.radius_m - second.solid.radius_m


def hull_distance(first: PlacedSolid, second: PlacedSolid) -> float:
    """Signed distance of the hulls, m: that of the solids where both are convex, else never more than that."""
    return _between_hulls(first, second) - first.solid.radius_m - second.solid.radius_m


def _between_hulls(first: PlacedSolid, second: PlacedSolid) -> float:
    found = fcl.DistanceResult()
    between = float(fcl.distance(first.core, second.core, _REQUEST, found))
    if between > CERTAIN_M:
        a, b = first.points, second.points
        if between - _gap(a, b, np.subtract(*reversed(found.nearest_points))) > CERTAIN_M:
            between = max(0.0, _gap(a, b, _shortest(a, b)))
    return between


def _between_surfaces(first: PlacedSolid, second: PlacedSolid, between_hulls: float) -> float:
    """Of cores; `between_hulls` where one is in the other or their surfaces meet."""
    objects = [fcl.CollisionObject(each.solid.boundary.tree, fcl.Transform(each.rotation, each.position)) for each in (first, second)]
    between = float(fcl.distance(*objects, fcl.DistanceRequest(), fcl.DistanceResult()))
    if between_hulls > 0.0:
        return max(between, between_hulls)
    return min(between_hulls, 0.0) if between <= 0.0 or _holds(first, second) or _holds(second, first) else between


def _holds(outer: PlacedSolid, inner: PlacedSolid) -> bool:
    """Whether a core that meets no surface of another is in it."""
    point = (inner.solid.boundary.vertices[0] @ inner.rotation.T + inner.position - outer.position) @ outer.rotation
    return abs(winding_number(outer.solid.boundary, point)) > 0.5


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


def parse_vector(text: str) -> Array:
    """The numbers of a URDF's attribute."""
    return np.array([float(word) for word in text.split()])


def _corners(low: Array, high: Array) -> Array:
    return np.stack(np.meshgrid(*np.array([low, high]).T), axis=-1).reshape(-1, 3)
