"""Convex solids for python-fcl, each as a core and a radius round it.

python-fcl puts round shapes up to some millimetres farther away than they are; between boxes and polyhedra it is right to well below a
micrometre. A ball is therefore a point with a radius, a capsule a line with a radius, and a cylinder a prism that contains it.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import fcl
import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from core.cell import Box, Capsule, Shape, Sphere
from core.errors import BadRobot

Array = NDArray[np.float64]

SIDES = 64
"""Of the prism round a cylinder: its edges stand out by 0.12 % of the radius."""

_REQUEST = fcl.DistanceRequest(enable_signed_distance=True)


@dataclass(frozen=True)
class Solid:
    """All points at most `radius_m` from a convex core.

    Args:
        core: python-fcl's geometry, about the solid's own origin.
        corners: (8, 3), corners of a box round the solid, in its own frame, m.
    """

    core: Any
    radius_m: float
    corners: Array


def box(size: Array) -> Solid:
    """A cuboid of that size (3,) about its origin, m."""
    return Solid(fcl.Box(*size), 0.0, _corners(-0.5 * size, 0.5 * size))


def ball(radius: float) -> Solid:
    """About its origin, m."""
    return Solid(fcl.Box(0.0, 0.0, 0.0), radius, _corners(np.full(3, -radius), np.full(3, radius)))


def capsule(radius: float, length: float) -> Solid:
    """Along z; `length` without the round ends, m."""
    half = np.array([radius, radius, 0.5 * length + radius])
    return Solid(fcl.Box(0.0, 0.0, length), radius, _corners(-half, half))


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
    return Solid(core, 0.0, _corners(points.min(axis=0), points.max(axis=0)))


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


def distance(first: Solid, first_object: Any, second: Solid, second_object: Any) -> float:
    """Signed distance of two placed solids, negative where they penetrate, m.

    Args:
        first_object, second_object: their cores, placed.
    """
    between_cores = fcl.distance(first_object, second_object, _REQUEST, fcl.DistanceResult())
    return float(between_cores) - first.radius_m - second.radius_m


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
