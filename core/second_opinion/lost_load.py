"""Where a load flies that comes off anywhere along a motion, as the second opinion sees it.

The load is the payload box. It comes off with the velocity that it has over one period, and falls freely until it is below the floor.
Watched are the ball round the box, which contains it however it tumbles, and its corners. Flights are sampled so finely that between two
samples nothing can come nearer by more than `FINE_M`; what is said is the least distance less what may lie between the samples.

From one set point to another no flight changes by more than the load has moved, and its velocity changed times the longest fall: as with
distances, most set points need not be looked at.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import fcl
import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Box, Capsule, Cell, Cylinder, Mesh, Shape, Sphere
from core.second_opinion.arm import Frames, frame_of_pose
from core.second_opinion.least import find_least
from core.second_opinion.solids import Solid, solids_of_standing

RESOLUTION_M = 0.005
"""How far from the least distance its figure may be; the verdict is exact."""
FINE_M = 0.001
"""How much nearer a flight may come between two samples of it."""
MOMENTS = 48
"""Of a flight, before those parts of it that matter are looked at more closely."""
FINER = 24
LONGEST_S = 3.0
NEAR_M = 0.1
"""Nearer than this to the box round a mesh, its triangles are looked at."""
POINT_M = 1e-6
"""Radius of the ball that stands for a point."""


class Flight(NamedTuple):
    """The flight of a lost load that comes nearest to a zone.

    Args:
        zone: its name.
        distance_m: signed, negative where the load gets into it.
        speed_m_s: of the fastest of the points that are watched, as it comes off.
        sample: the set point at which it comes off.
    """

    zone: str
    distance_m: float
    speed_m_s: float
    sample: int


def nearest_flight(cell: Cell, payload_box: Box, sensor: Frames, period: float) -> Flight | None:
    """The flight nearest to a zone; None where there is no zone.

    Args:
        sensor: its N placements in the world, one for each set point.
        period: between them, s.
    """
    if not cell.zones:
        return None
    centre = np.array(payload_box.pose.xyz_m)
    half = 0.5 * np.array(payload_box.size_m)
    signs = np.array([[a, b, c] for a in (-1.0, 1.0) for b in (-1.0, 1.0) for c in (-1.0, 1.0)])
    points = np.vstack([centre, signs * half @ frame_of_pose(payload_box.pose).rotation.T + centre])
    radius = np.array([np.sqrt(half @ half), *np.zeros(8)])
    x = np.einsum("nij,kj->nki", sensor.rotation, points) + sensor.position[:, None]
    v = np.diff(x, axis=0, append=x[-1:]) / period
    fall = _Fall(cell.gravity, cell.floor_z_m)
    longest = max(fall.seconds(x[:, k], v[:, k]).max() for k in range(len(points)))
    changed = np.linalg.norm(np.diff(x, axis=0), axis=2) + longest * np.linalg.norm(np.diff(v, axis=0), axis=2)
    way = np.concatenate([[0.0], np.cumsum(changed.max(axis=1))]) if len(x) > 1 else np.zeros(1)
    solids = solids_of_standing(cell)[len(cell.obstacles) :]
    zones = [
        distance_to_mesh(zone.shape, solid) if isinstance(zone.shape, Mesh) else distance_to(zone.shape)
        for zone, solid in zip(cell.zones, solids, strict=True)
    ]

    def margin(zone: int, sample: int) -> float:
        return fall.nearest(x[sample], v[sample], radius, zones[zone])

    least = find_least([way] * len(zones), margin, [RESOLUTION_M] * len(zones))
    speed = float(np.linalg.norm(v[least.sample], axis=1).max())
    return Flight(cell.zones[least.pair].name, least.margin, speed, least.sample)


Distance = Callable[[Array], Array]
"""From points (..., 3) in the world to their signed distances (...) from a shape, m."""


def distance_to(shape: Shape) -> Distance:
    """The distance of points from a zone's shape."""
    frame = frame_of_pose(shape.pose)

    def local(points: Array) -> Array:
        return (points - frame.position) @ frame.rotation

    match shape:
        case Box():
            half = 0.5 * np.array(shape.size_m)
            return lambda points: _outside(np.abs(local(points)) - half)
        case Sphere():
            radius = shape.radius_m
            return lambda points: np.linalg.norm(local(points), axis=-1) - radius
        case Capsule():
            radius, end = shape.radius_m, np.array([0.0, 0.0, 0.5 * shape.length_m])
            return lambda points: np.linalg.norm(local(points) - np.clip(local(points), -end, end), axis=-1) - radius
        case Cylinder():
            reach = np.array([shape.radius_m, 0.5 * shape.length_m])
            return lambda points: _outside(_in_half_plane(local(points)) - reach)


def distance_to_mesh(mesh: Mesh, solid: Solid) -> Distance:
    """The distance of points from the triangles of a zone, which no flight gets through unseen; never negative.

    Farther than `NEAR_M` from the box round it, that from this box.
    """
    frame = frame_of_pose(mesh.pose)
    return lambda points: _from_surface((points - frame.position) @ frame.rotation, solid)


def _from_surface(points: Array, solid: Solid) -> Array:
    """Of points (..., 3) in the solid's own frame."""
    low, high = solid.corners.min(axis=0), solid.corners.max(axis=0)
    apart = np.linalg.norm(np.maximum(np.maximum(low - points, points - high), 0.0), axis=-1)
    tree, point = fcl.CollisionObject(solid.boundary.tree), fcl.CollisionObject(fcl.Sphere(POINT_M))
    for where in zip(*np.nonzero(apart < NEAR_M), strict=True):
        point.setTranslation(points[where])
        found = fcl.distance(tree, point, fcl.DistanceRequest(), fcl.DistanceResult())
        apart[where] = max(float(found), 0.0) + POINT_M
    return np.asarray(apart)


def _in_half_plane(points: Array) -> Array:
    """(..., 2), distance from the z axis and along it."""
    return np.stack([np.hypot(points[..., 0], points[..., 1]), np.abs(points[..., 2])], axis=-1)


def _outside(beyond: Array) -> Array:
    """Signed distance of points that are `beyond` (..., k) the faces of a box (or of a cylinder, in a half plane), negative inside each."""
    return np.asarray(np.linalg.norm(np.maximum(beyond, 0.0), axis=-1) + np.minimum(beyond.max(axis=-1), 0.0))


class _Fall:
    """Free flights down to the floor.

    Args:
        gravity: (3,), m/s2.
        floor_z: m.
    """

    def __init__(self, gravity: Array, floor_z: float) -> None:
        self._g, self._floor = gravity, floor_z

    def seconds(self, x: Array, v: Array) -> Array:
        """(N,), how long points at x (N, 3) with velocities v (N, 3) fly until they are below the floor."""
        down = -self._g[2]
        up = v[:, 2]
        left = np.maximum(up**2 + 2.0 * down * (x[:, 2] - self._floor), 0.0)
        return np.asarray(np.minimum(np.maximum((up + np.sqrt(left)) / down, 0.0), LONGEST_S))

    def nearest(self, x: Array, v: Array, radius: Array, distance: Distance) -> float:
        """Least signed distance of balls of these radii (k,) that fly from x (k, 3) with velocities v (k, 3); up to `FINE_M` too small."""
        each = np.arange(len(x))[:, None]
        t = self.seconds(x, v)[:, None] * np.sqrt(np.linspace(0.0, 1.0, MOMENTS))
        least = np.inf
        while True:
            apart = self._apart(x, v, radius, distance, each, t)
            least = min(least, float(apart.min()))
            row, interval = np.nonzero(self._below(v, each, t, apart) < least - FINE_M)
            if len(row) == 0:
                return least - FINE_M
            start, end = t[row, interval, None], t[row, interval + 1, None]
            each, t = each[row], start + (end - start) * np.linspace(0.0, 1.0, FINER)

    def _apart(self, x: Array, v: Array, radius: Array, distance: Distance, each: NDArray[np.intp], t: Array) -> Array:
        """(m, T), distances of points `each` (m, 1) at times t (m, T)."""
        place = x[each] + v[each] * t[..., None] + 0.5 * self._g * (t**2)[..., None]
        return np.asarray(distance(place) - radius[each])

    def _below(self, v: Array, each: NDArray[np.intp], t: Array, apart: Array) -> Array:
        """(m, T - 1), what no distance between two samples is below.

        A speed under constant acceleration is a convex function of time: the way between two samples is at most the mean of their speeds
        times the time.
        """
        speed = np.linalg.norm(v[each] + self._g * t[..., None], axis=-1)
        way = 0.5 * (speed[:, 1:] + speed[:, :-1]) * np.diff(t, axis=1)
        return np.asarray(0.5 * (apart[:, 1:] + apart[:, :-1] - way))
