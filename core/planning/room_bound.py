"""How much room a configuration has at most: from points of the bodies, a hundred times faster than by the distances of the bodies.

No body is farther from a thing than any of its own points is. Of ten thousand candidates a few hundred can then be the best, and only
their distances are computed.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import coal
import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.planning.link_room import LinkRoom
from core.planning.solid_distance import BOX, CAPSULE, CYLINDER, POLYHEDRON, Solid, Solids, signed_distance
from core.robot.bodies import Body
from core.robot.chain import Chain, joint_frames
from core.robot.collision import CollisionModel

ROUNDING_M = 1e-6
"""Coal's distances are as exact."""
DIRECTIONS = np.array([way for way in product((-1.0, 0.0, 1.0), repeat=3) if any(way)])
"""(26, 3), in which the outermost points of a body are taken."""


@njit(cache=True)
def _least_room(
    chain: Chain, q: Array, points: Array, radius: Array, carrier: NDArray[np.int64], first: NDArray[np.int64], ball: Array,
    pairs: NDArray[np.int64], required: Array, share: Array, scale: Array, clearance: float, solids: Solids,
) -> Array:  # fmt: skip
    n = q.shape[1]
    R, p = np.empty((n + 1, 3, 3)), np.empty((n + 1, 3))
    world = np.empty((len(points), 3))
    middle = np.empty((len(ball), 3))
    out = np.ones(len(q))
    for k in range(len(q)):
        joint_frames(chain.placements, chain.axes, q[k], R, p)
        for i in range(len(points)):
            j = carrier[i]
            for r in range(3):
                world[i, r] = p[j, r] + R[j, r, 0] * points[i, 0] + R[j, r, 1] * points[i, 1] + R[j, r, 2] * points[i, 2]
        for b in range(len(ball)):
            j = carrier[first[b]]
            for r in range(3):
                middle[b, r] = p[j, r] + R[j, r, 0] * ball[b, 0] + R[j, r, 1] * ball[b, 1] + R[j, r, 2] * ball[b, 2]
        for m in range(len(pairs)):
            body, s = pairs[m]
            within = signed_distance(solids, s, middle[body, 0], middle[body, 1], middle[body, 2]) - ball[body, 3]
            if ((within + ROUNDING_M - required[m]) / share[m] + clearance) / scale[m] >= out[k]:
                continue  # none of its points is nearer than the ball round them
            nearest = np.inf
            for i in range(first[body], first[body + 1]):
                nearest = min(nearest, signed_distance(solids, s, world[i, 0], world[i, 1], world[i, 2]) - radius[i])
            room = (nearest + ROUNDING_M - required[m]) / share[m] + clearance
            out[k] = min(out[k], room / scale[m])
    return out


class RoomBound:
    """Upper bounds of the least of D of Eq. (6) (`LinkRoom.normalise`); to be made anew after `CollisionModel.move`.

    Args:
        room: of the same collision model.
    """

    def __init__(self, chain: Chain, collision: CollisionModel, room: LinkRoom) -> None:
        watched = collision.pairs[0]
        kept = [k for k, (_, thing) in enumerate(watched) if not isinstance(thing.geometry, coal.ConvexBase)]  # a mesh bounds nothing here
        pairs = [watched[k] for k in kept]
        bodies = list({id(body): body for body, _ in pairs}.values())
        things = list({id(thing): thing for _, thing in pairs}.values())
        self._chain, self._clearance = chain, collision.cell.limits.clearance_m
        of_bodies = [_points_of(body) for body in bodies]
        self._points = np.concatenate([points for points, _ in of_bodies] or [np.zeros((0, 3))])
        self._radius = np.concatenate([np.full(len(points), radius) for points, radius in of_bodies] or [np.zeros(0)])
        counts = [len(points) for points, _ in of_bodies]
        self._carrier = np.repeat(np.array([body.joint - 1 for body in bodies], dtype=np.int64), counts)
        self._first = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        self._balls = np.array([_ball_round(points, radius) for points, radius in of_bodies]).reshape(-1, 4)
        number = {id(each): k for each_of in (bodies, things) for k, each in enumerate(each_of)}
        self._pairs = np.array([[number[id(body)], number[id(thing)]] for body, thing in pairs], dtype=np.int64).reshape(-1, 2)
        self._required, self._share = collision.required_m[kept], collision.share[kept]
        scales = dict(zip(room.names, room.scale, strict=True))
        self._scale = np.array([scales[body.name] for body, _ in pairs])
        self._solids = Solids.of([_solid_of(thing, collision.placement_of(thing)) for thing in things])

    def least(self, q: Array) -> Array:
        """(N,), what the least of D is at most at q (N, n); at most 1."""
        return np.asarray(
            _least_room(
                self._chain, np.ascontiguousarray(q), self._points, self._radius, self._carrier, self._first, self._balls,
                self._pairs, self._required, self._share, self._scale, self._clearance, self._solids,
            )
        )  # fmt: skip


def _ball_round(points: Array, radius: float) -> Array:
    """(4,), centre and radius of a ball that holds the points (k, 3) and what is round each."""
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    return np.append(centre, np.linalg.norm(points - centre, axis=1).max() + radius)


def _points_of(body: Body) -> tuple[Array, float]:
    """Points (k, 3) in the frame of the joint that carries a body, and a radius about them that is in it as well, m."""
    points, radius = _points_of_geometry(body.geometry)
    return points @ body.placement.rotation.T + body.placement.translation, radius


def _points_of_geometry(geometry: Any) -> tuple[Array, float]:
    match geometry:
        case coal.Box():
            return DIRECTIONS * np.asarray(geometry.halfSide), 0.0
        case coal.Sphere():
            return np.zeros((1, 3)), float(geometry.radius)
        case coal.Capsule():
            return np.linspace(-1.0, 1.0, 5)[:, None] * [0.0, 0.0, geometry.halfLength], float(geometry.radius)
        case coal.Cylinder():
            angle = np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False)
            ring = np.column_stack([geometry.radius * np.cos(angle), geometry.radius * np.sin(angle), np.zeros(12)])
            height = np.array([0.0, 0.0, geometry.halfLength])
            return np.concatenate([ring + z * height for z in (-1.0, 0.0, 1.0)]), 0.0
    corners = np.asarray(geometry.points())
    return corners[np.unique((corners @ DIRECTIONS.T).argmax(axis=0))], 0.0


def _solid_of(thing: Body, placement: Any) -> Solid:
    """A thing where it is now; the floor too."""
    R, p, geometry = np.array(placement.rotation), np.array(placement.translation), thing.geometry
    match geometry:
        case coal.Box():
            return Solid(BOX, tuple(geometry.halfSide), R, p)
        case coal.Sphere():
            return Solid(CAPSULE, (geometry.radius, 0.0, 0.0), R, p)
        case coal.Capsule():
            return Solid(CAPSULE, (geometry.radius, 0.0, geometry.halfLength), R, p)
        case coal.Cylinder():
            return Solid(CYLINDER, (geometry.radius, np.inf, geometry.halfLength), R, p)
    return Solid(POLYHEDRON, (0.0, 0.0, 0.0), R, p, np.append(geometry.n, geometry.d)[None])
