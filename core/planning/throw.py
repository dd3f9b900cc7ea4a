"""Where a load flies that comes off on the way, and whether that is into a protected zone (section 4 of the paper).

The load is the whole payload box. It is released with its rigid-body velocity at some moment of the motion, then falls freely down to the
floor. Watched are the ball round the box, which flies with the box's centre and contains the tumbling box as long as the centre of mass is
near it, and every corner as if it came off by itself. What the load does after it has hit an obstacle is not predicted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numba import njit
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Box, Cell, Mesh
from core.payload.shapes import StandingShape
from core.planning.solid_distance import Solid, Solids, signed_distance, solid_of_hull, solid_of_shape
from core.robot.bodies import standing_parts
from core.robot.model import SensorPose
from core.robot.trajectory import AngularProfile

PAD_M = 0.005
"""Added to everything that flies, for the moments between those that are looked at."""

_MOMENTS = 24
_LONGEST_FALL_S = 3.0
_SHORTEST_STEP_S = 0.001


@dataclass(frozen=True)
class Throw:
    """The flight of a released load that comes nearest to a protected zone.

    Args:
        zone: name of that zone.
        distance_m: smallest distance between them, at most a tenth too large; negative where the load would enter the zone.
        time_s: moment of release, from the start of the motion.
        speed_m_s: of the fastest point at release.
    """

    zone: str
    distance_m: float
    time_s: float
    speed_m_s: float


@dataclass(frozen=True)
class Loads:
    """What flies: points of the load with a radius, and the moments of release, in the frame of the sensor at the start.

    Args:
        time: (M,), s.
        position: (M, K, 3), of the K points, relative to the sensor origin, in the sensor's axes at the start, m.
        velocity: (M, K, 3), likewise, m/s.
        radius: (K,), m.
    """

    time: Array
    position: Array
    velocity: Array
    radius: Array


def loads_of(box: Box, axis: Array, profile: AngularProfile | None) -> Loads:
    """The moments of a rotation about `axis` (3,), a unit vector in the sensor frame, at which the load may come off.

    `None` is a hold: one moment, no velocity. Moments are the extremes of rate and angle and evenly spaced ones.
    """
    points, radius = _list_flying_points(box)
    if profile is None:
        return Loads(np.zeros(1), points[None], np.zeros((1, *points.shape)), radius)
    extremes = [f(values) for f in (np.argmin, np.argmax) for values in (profile.rate, profile.angle)]
    rows = np.unique(np.concatenate((np.linspace(0, len(profile.angle) - 1, _MOMENTS).astype(int), extremes)))
    turned = Rotation.from_rotvec(profile.angle[rows, None] * axis).as_matrix()
    position = np.einsum("mij,kj->mki", turned, points)
    velocity = np.cross(profile.rate[rows, None, None] * axis, position)
    return Loads(profile.period * rows, position, velocity, radius)


def loads_along(box: Box, rotation: Array, position: Array, period: float) -> Loads:
    """The same for any motion of the sensor, (N, 3, 3) and (N, 3), and in the axes in which that is given; every moment counts."""
    points, radius = _list_flying_points(box)
    there = position[:, None] + points @ np.swapaxes(rotation, 1, 2)
    return Loads(np.arange(len(there), dtype=np.float64) * period, there, np.gradient(there, period, axis=0), radius)


def _list_flying_points(box: Box) -> tuple[Array, Array]:
    """Points of a box (K, 3), its centre first, in the frame it is given in, and the radius that flies with each."""
    centre = box.pose.translation
    points = np.vstack((centre[None], box.corners))
    radius = np.full(len(points), PAD_M)
    radius[0] += np.linalg.norm(box.corners[0] - centre)
    return points, radius


@njit(cache=True)
def _nearest_flight(
    position: Array,
    velocity: Array,
    radius: Array,
    gravity: Array,
    floor_z: float,
    solids: Solids,
) -> tuple[float, int, int]:
    """Smallest distance of any flight to any shape, with its release and its shape.

    Marches along each flight: from a distance d the load needs some time to come nearer by more than d minus the least distance so far, or
    by more than a tenth of d. Where there is room the steps are long; the result is at most a tenth too large, and contact is not missed.
    """
    g = np.sqrt(gravity[0] ** 2 + gravity[1] ** 2 + gravity[2] ** 2)
    least, release, shape = np.inf, 0, 0
    for m in range(position.shape[0]):
        for k in range(position.shape[1]):
            x, v = position[m, k], velocity[m, k]
            speed = np.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2)
            t = 0.0
            while t < _LONGEST_FALL_S:
                y0 = x[0] + v[0] * t + 0.5 * gravity[0] * t * t
                y1 = x[1] + v[1] * t + 0.5 * gravity[1] * t * t
                y2 = x[2] + v[2] * t + 0.5 * gravity[2] * t * t
                if t > 0.0 and y2 < floor_z:
                    break
                nearest = np.inf
                for s in range(len(solids.kind)):
                    d = signed_distance(solids, s, y0, y1, y2)
                    nearest = min(nearest, d - radius[k])
                    if d - radius[k] < least:
                        least, release, shape = d - radius[k], m, s
                u = speed + g * t  # in dt the load flies at most u dt + g dt^2 / 2
                room = max(nearest - least, 0.1 * nearest, 0.0)
                t += max((np.sqrt(u * u + 2.0 * g * room) - u) / g, _SHORTEST_STEP_S)
    return least, release, shape


def _solids_of(shape: StandingShape, parts: Sequence[Array]) -> list[Solid]:
    """A zone's shape; of a mesh its convex parts."""
    return [solid_of_hull(part, shape.pose) for part in parts] if isinstance(shape, Mesh) else [solid_of_shape(shape)]


class ThrowCheck:
    """The flights of released loads in one cell."""

    def __init__(self, cell: Cell) -> None:
        parts = standing_parts(cell)
        solids = [(zone.name, solid) for zone in cell.zones for solid in _solids_of(zone.shape, parts.get(zone.name, ()))]
        self._names = [name for name, _ in solids]
        self._gravity = cell.gravity
        self._floor_z = cell.floor_z_m
        self._solids = Solids.of([solid for _, solid in solids])

    def nearest(self, loads: Loads, rotation: Array, position: Array) -> Throw | None:
        """The flight nearest to a zone when the motion starts with the sensor at a pose; None when the cell has no zones.

        Args:
            rotation, position: (3, 3) and (3,), the sensor in the world at the start of the motion.
        """
        if not self._names:
            return None
        return self._nearest(replace(loads, position=position + loads.position @ rotation.T, velocity=loads.velocity @ rotation.T))

    def into_zone(self, box: Box, sensor: SensorPose, period: float) -> Throw | None:
        """The first flight into a zone of a load that comes off at any sample of a motion; None where none gets there.

        From one sample to another no flight changes by more than the load has moved, and its velocity changed times the longest fall. Those
        samples are passed over at which it can therefore not have come into a zone.

        Args:
            box: the load, sensor frame.
            sensor: (N, 3, 3) and (N, 3), in the world.
            period: between samples, s.
        """
        if not self._names:
            return None
        loads = loads_along(box, sensor.rotation, sensor.position, period)
        moved, changed = (np.linalg.norm(np.diff(each, axis=0), axis=2).max(axis=1) for each in (loads.position, loads.velocity))
        way = np.concatenate(([0.0], np.cumsum(moved + self._longest_fall_s(loads) * changed)))
        m = 0
        while m < len(way):
            one = slice(m, m + 1)
            throw = self._nearest(Loads(loads.time[one], loads.position[one], loads.velocity[one], loads.radius))
            if throw.distance_m < 0.0:
                return throw
            m = max(m + 1, int(np.searchsorted(way, way[m] + throw.distance_m / 1.1)))
        return None

    def drop(self, box: Box, sensor: SensorPose) -> Throw | None:
        """The nearest flight of a load that comes off at rest, at any of some poses; None when the cell has no zones."""
        if not self._names:
            return None
        points, radius = _list_flying_points(box)
        centres = sensor.position + sensor.rotation @ points[0]
        return self._nearest(Loads(np.zeros(len(centres)), centres[:, None], np.zeros((len(centres), 1, 3)), radius[:1]))

    def _nearest(self, loads: Loads) -> Throw:
        """The flight nearest to a zone of loads given in the world."""
        x, v = np.ascontiguousarray(loads.position), np.ascontiguousarray(loads.velocity)
        distance, m, k = _nearest_flight(x, v, loads.radius, self._gravity, self._floor_z, self._solids)
        speed = float(np.linalg.norm(v[m], axis=1).max())
        return Throw(self._names[k], float(distance), float(loads.time[m]), speed)

    def _longest_fall_s(self, loads: Loads) -> float:
        """No point of the loads falls longer than this."""
        g, up = -float(self._gravity[2]), float(loads.velocity[..., 2].max())
        height = max(float(loads.position[..., 2].max()) - self._floor_z, 0.0)
        return min((max(up, 0.0) + float(np.sqrt(max(up, 0.0) ** 2 + 2.0 * g * height))) / g, _LONGEST_FALL_S)
