"""Distances of the robot and the payload box to obstacles, protected zones and themselves: Coal through Pinocchio.

Meshes are replaced by their convex hulls. Every pair has a required distance: the cell's clearance to obstacles and
zones, its self-clearance between links. A *margin* is a distance minus what is required; margins are signed, negative
where a pair is too close.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.bodies import Body, SpeedPoints, corners_of, fixed_body, link_bodies, payload_body, reach_of
from core.cell import Box, Cell, Obstacle, Pose, Zone
from core.cell_contradictions import BASE_IN_OBSTACLE
from core.errors import BadCell
from core.robot import RobotModel

__all__ = ["Body", "CollisionModel", "Nearest", "SpeedPoints"]

Array = NDArray[np.float64]

CONTACT_M = 0.001  # links that provably stay this far apart cannot touch
MOST_DIVISIONS = 20_000  # of the joints' ranges in such a proof; a pair that needs more is kept


@dataclass(frozen=True)
class Nearest:
    """The nearest pair of bodies.

    Args:
        distance_m: signed distance, negative when they penetrate; infinite when there is no pair.
        required_m: what the cell requires between them.
        first: link name, or "payload".
        second: name of the obstacle, the protected zone or the other link.
        point_first, point_second: (3,), the nearest points, world frame, m.
    """

    distance_m: float
    required_m: float
    first: str
    second: str
    point_first: Array
    point_second: Array

    @property
    def margin_m(self) -> float:
        """Distance minus what is required."""
        return self.distance_m - self.required_m


class CollisionModel:
    """Distances of one robot with one payload box in one cell.

    Pairs are the moving links and the payload box against all obstacles and zones, and links (with the base) that have
    at least two joints between them. Left out are pairs that can never matter and would hide what the others do: a link
    that only the first joint moves with an obstacle that it clears at every angle of that joint (`move` looks at those
    pairs again), and links with two joints between them that cannot touch at any angles of the two, or that are closer
    than the self-clearance at home already: bodies of one wrist whose simplified shapes overlap.

    Args:
        cell: obstacles, zones and clearances.
        robot: the kinematics of the same cell.
        payload_box: in the sensor frame.

    Raises:
        BadCell: something stands where the robot's base is, or the home configuration is too close to something.
    """

    def __init__(self, cell: Cell, robot: RobotModel, payload_box: Box) -> None:
        self.cell = cell
        self.robot = robot
        self.payload_box = payload_box
        bodies = [*link_bodies(cell, robot), payload_body(robot, payload_box)]
        things = [fixed_body(item.name, item.shape) for item in _standing(cell)]
        self.points = corners_of(bodies)
        self.reach = reach_of(robot, self.points)
        """(n,), the largest distance from axis i of any point behind joint i over all configurations, m."""
        self._environment = _Pairs(robot, cell.limits.clearance_m, [(body, thing) for body in bodies if body.joint > 0 for thing in things])
        links = [(a, b) for a in bodies for b in bodies if a.joint - b.joint >= 2]
        self._self = _Pairs(robot, cell.limits.self_clearance_m, [pair for pair in links if _can_collide(cell, robot, pair)])
        for thing in things:
            self._choose_pairs(thing.name)
        _check_base(cell, bodies, things)
        _check_home(cell, self)

    @property
    def pairs(self) -> tuple[list[tuple[Body, Body]], list[tuple[Body, Body]]]:
        """The pairs that are watched: against obstacles and zones, and between links."""
        return self._environment.active, self._self.active

    @property
    def watched(self) -> NDArray[np.bool_]:
        """Which pairs are watched: `move` may change it."""
        return np.concatenate((self._environment.watched, self._self.watched))

    def nearest(self, q: Array) -> Nearest:
        """The pair with the smallest margin at q (n,)."""
        return min(self._environment.nearest(q), self._self.nearest(q), key=lambda pair: pair.margin_m)

    def margin(self, q: Array) -> float:
        """Smallest distance minus required distance over all pairs at q (n,), m; negative if q is not finite."""
        return min(self._environment.margin(q), self._self.margin(q))

    def margins(self, q: Array) -> Array:
        """Distance minus required distance at q (n,) of every pair, obstacles and zones first, m; infinite where it is not watched.

        `margins(q)[watched]` are those of `pairs`, in their order.
        """
        return np.concatenate((self._environment.margins(q), self._self.margins(q)))

    def is_free(self, q: Array, extra_m: float = 0.0) -> bool:
        """Whether every margin at q (n,) exceeds `extra_m`; cheaper than `margin`."""
        return self._environment.is_free(q, extra_m) and self._self.is_free(q, extra_m)

    def obstacle_distance(self, q: Array) -> Nearest:
        """The smallest distance to obstacles and protected zones at q (n,), without `left_out_distance`; infinite when there is none."""
        return self._environment.nearest(q)

    def left_out_distance(self, q: Array) -> Nearest:
        """The smallest distance at q (n,) of links that only the first joint moves to what they clear anyway: pairs that are left out.

        Infinite where none is left out.
        """
        return self._environment.nearest_left_out(q)

    def obstacle_margin(self, q: Array) -> float:
        """Smallest margin to obstacles and zones at q (n,), m; infinite when the cell has none."""
        return self._environment.margin(q)

    def obstacle_margins(self, q: Array) -> Array:
        """The first part of `margins(q)`: every pair with an obstacle or a zone, m; infinite where it is not watched."""
        return self._environment.margins(q)

    def self_margin(self, q: Array) -> float:
        """Smallest margin between links at q (n,), m."""
        return self._self.margin(q)

    def motion_bound(self, q_a: Array, q_b: Array) -> float:
        """Upper bound of how far any point moves on the straight line between two configurations, m.

        The sum over the joints of |dq_i| times `reach` i. No margin changes by more than this between q_a and q_b, also
        none between two links.
        """
        return float(np.abs(np.subtract(q_b, q_a)) @ self.reach)

    def move(self, name: str, pose: Pose) -> None:
        """Moves an obstacle or a zone (a live position); world frame.

        Raises:
            BadCell: there is no obstacle or zone of that name.
        """
        names = [item.name for item in _standing(self.cell)]
        if name not in names:
            raise BadCell(f"{self.cell.folder.name}/cell.toml: obstacles and zones", repr(name), f"one of {names}")
        self._environment.move(name, pin.SE3(pose.rotation, pose.translation))
        self._choose_pairs(name)

    def _choose_pairs(self, name: str) -> None:
        """Leaves out, or takes back, the pairs of `name` with links that only the first joint moves."""
        for k, (body, thing) in enumerate(self._environment.bodies):
            if thing.name == name and body.joint == 1:
                there = replace(thing, placement=self._environment.placement(name))
                self._environment.use(k, not _keeps(self.robot, (body, there), self.cell.limits.clearance_m))


class _Pairs:
    """Pairs that share one required distance, so that a single call returns the one that matters."""

    def __init__(self, robot: RobotModel, required_m: float, bodies: list[tuple[Body, Body]]) -> None:
        self.required_m = required_m
        self.bodies = bodies
        self._model, self._data = robot.model, robot.model.createData()
        self._geometry = pin.GeometryModel()
        self._ids: dict[str, int] = {}
        for pair in bodies:
            self._geometry.addCollisionPair(pin.CollisionPair(*[self._add(body) for body in pair]))
        self._results = self._geometry.createData()
        self.watched = np.ones(len(bodies), dtype=bool)
        """(n_pairs,), which of `bodies` are taken into the computation."""
        self._extra_m = -inf

    def _add(self, body: Body) -> int:
        """Index of the geometry object of a body, which is added when it is new."""
        key = f"{body.joint} {body.name} {id(body)}"
        if key not in self._ids:
            shape = pin.GeometryObject(key, body.joint, body.placement, body.geometry)
            self._ids[key] = self._geometry.addGeometryObject(shape)
        return self._ids[key]

    def _nearest_pair(self, q: Array) -> int:
        return int(pin.computeDistances(self._model, self._data, self._geometry, self._results, q))

    def margin(self, q: Array) -> float:
        if not self.watched.any():
            return inf
        return float(self._results.distanceResults[self._nearest_pair(q)].min_distance) - self.required_m

    def margins(self, q: Array) -> Array:
        """Of all `bodies`, infinite where a pair is left out."""
        if self.watched.any():
            pin.computeDistances(self._model, self._data, self._geometry, self._results, q)
        distances = np.array([result.min_distance for result in self._results.distanceResults])
        return np.where(self.watched, distances - self.required_m, inf)

    def nearest(self, q: Array) -> Nearest:
        if not self.watched.any():
            return Nearest(inf, self.required_m, "robot", "nothing", np.full(3, np.nan), np.full(3, np.nan))
        k = self._nearest_pair(q)
        result = self._results.distanceResults[k]
        first, second = self.bodies[k]
        points = np.array(result.getNearestPoint1()), np.array(result.getNearestPoint2())
        return Nearest(float(result.min_distance), self.required_m, first.name, second.name, *points)

    def nearest_left_out(self, q: Array) -> Nearest:
        """The nearest of those that are not watched, without its points; infinite where all are."""
        nowhere = np.full(3, np.nan)
        nearest = Nearest(inf, self.required_m, "robot", "nothing", nowhere, nowhere)
        pin.forwardKinematics(self._model, self._data, q)
        for k in np.flatnonzero(~self.watched):
            first, second = self.bodies[k]
            placement = self._data.oMi[first.joint] * first.placement
            distance = _distance(first.geometry, placement, second.geometry, self.placement(second.name))
            if distance < nearest.distance_m:
                nearest = Nearest(distance, self.required_m, first.name, second.name, nowhere, nowhere)
        return nearest

    def is_free(self, q: Array, extra_m: float) -> bool:
        if not self.watched.any():
            return True
        if extra_m != self._extra_m:
            for request in self._results.collisionRequests:
                request.security_margin = self.required_m + extra_m
            self._extra_m = extra_m
        return not pin.computeCollisions(self._model, self._data, self._geometry, self._results, q, True)

    def use(self, k: int, wanted: bool) -> None:
        """Takes pair k into the computation or leaves it out."""
        (self._results.activateCollisionPair if wanted else self._results.deactivateCollisionPair)(k)
        self.watched[k] = wanted

    @property
    def active(self) -> list[tuple[Body, Body]]:
        """The pairs that are taken into the computation."""
        return [pair for pair, watched in zip(self.bodies, self.watched, strict=True) if watched]

    def _object(self, name: str) -> Any:
        """Geometry object of a fixed body."""
        thing = next(second for _, second in self.bodies if second.name == name)
        return self._geometry.geometryObjects[self._add(thing)]

    def placement(self, name: str) -> Any:
        return self._object(name).placement

    def move(self, name: str, placement: Any) -> None:
        self._object(name).placement = placement


def _standing(cell: Cell) -> list[Obstacle | Zone]:
    """Everything that the robot must keep away from."""
    return [*cell.obstacles, *cell.zones]


def _can_collide(cell: Cell, robot: RobotModel, pair: tuple[Body, Body]) -> bool:
    """Whether two links need watching; see `CollisionModel`."""
    first, second = pair
    if first.joint - second.joint > 2:
        return True
    at_home = _Pairs(robot, cell.limits.self_clearance_m, [pair]).margin(np.array(cell.robot.home_rad))
    return at_home >= 0.0 and not _keeps(robot, pair, CONTACT_M)


def _keeps(robot: RobotModel, pair: tuple[Body, Body], required_m: float) -> bool:
    """Whether two bodies keep a distance at all angles of the joints between them, proven by dividing their ranges.

    Within a box of angles no distance is smaller than the one at its centre minus the largest motion from there.
    """
    first, second = pair
    between = np.arange(second.joint, first.joint)
    reach = reach_of(robot, corners_of([first]))[between]
    low = robot.lower[between]
    margin = _Pairs(robot, required_m, [pair]).margin
    q = pin.neutral(robot.model)
    boxes = [(low, np.minimum(robot.upper[between], low + 2.0 * np.pi))]
    for _ in range(MOST_DIVISIONS):
        if not boxes:
            return True
        low, high = boxes.pop()
        q[between] = middle = 0.5 * (low + high)
        least = margin(q)
        widths = (high - low) * reach
        if least < 0.0:
            return False
        if least < 0.5 * widths.sum():
            k = int(np.argmax(widths))
            for part in (np.array([low[k], middle[k]]), np.array([middle[k], high[k]])):
                ends = np.array([low, high])
                ends[:, k] = part
                boxes.append((ends[0], ends[1]))
    return False


def _distance(first: Any, first_placement: Any, second: Any, second_placement: Any) -> float:
    """Signed distance of two shapes, m."""
    transforms = [coal.Transform3s(T.rotation, T.translation) for T in (first_placement, second_placement)]
    return float(coal.distance(first, transforms[0], second, transforms[1], coal.DistanceRequest(), coal.DistanceResult()))


def _check_base(cell: Cell, bodies: list[Body], things: list[Body]) -> None:
    for base in (body for body in bodies if body.joint == 0):
        for thing in things:
            distance = _distance(base.geometry, base.placement, thing.geometry, thing.placement)
            if distance < -BASE_IN_OBSTACLE:
                raise BadCell(
                    f"{cell.folder.name}/cell.toml: {thing.name}",
                    f"{base.name!r} of the robot {-distance:.3f} m inside it",
                    f"the robot's base outside (at most {BASE_IN_OBSTACLE} m sunk into what it is mounted on)",
                    thing.name,
                )


def _check_home(cell: Cell, collision: CollisionModel) -> None:
    nearest = collision.nearest(np.array(cell.robot.home_rad))
    if nearest.margin_m < 0.0:
        raise BadCell(
            f"{cell.folder.name}/cell.toml: robot.home_rad",
            f"{nearest.first!r} {nearest.distance_m:.3f} m from {nearest.second!r}",
            f"at least {nearest.required_m:.3f} m at home",
            nearest.second,
        )
