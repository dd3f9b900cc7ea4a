"""Pairs of bodies that share a required distance, and their distances by one call of Coal through Pinocchio."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from core.array import Array
from core.robot.bodies import (
    Body,
)  # fmt: skip
from core.robot.model import RobotModel


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


class PairGroup:
    """Pairs that share one required distance, so that a single call returns the one that matters; all of them are watched at first."""

    def __init__(self, robot: RobotModel, required_m: float, bodies: list[tuple[Body, Body]]) -> None:
        self.required_m = required_m
        self.bodies: list[tuple[Body, Body]] = []
        self._index: dict[tuple[int, int], int] = {}
        self._model, self._data = robot.model, robot.model.createData()
        self._geometry = pin.GeometryModel()
        self._ids: dict[str, int] = {}
        self.watched = np.ones(0, dtype=bool)
        """(n_pairs,), which of `bodies` are taken into the computation."""
        self.add(bodies)

    def add(self, pairs: list[tuple[Body, Body]]) -> None:
        """More pairs, watched at first."""
        for pair in pairs:
            self._index[_key(pair)] = len(self.bodies)
            self.bodies.append(pair)
            self._geometry.addCollisionPair(pin.CollisionPair(*[self._add_body(body) for body in pair]))
        self._results = self._geometry.createData()
        for k in np.flatnonzero(~self.watched):
            self._results.deactivateCollisionPair(int(k))
        self.watched = np.append(self.watched, np.ones(len(pairs), dtype=bool))
        self._extra_m = -inf

    def _add_body(self, body: Body) -> int:
        """Index of the geometry object of a body, which is added when it is new."""
        key = _id(body)
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
        if not self.watched.any():
            return np.full(len(self.bodies), inf)
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

    def is_free(self, q: Array, extra_m: float) -> bool:
        if not self.watched.any():
            return True
        if extra_m != self._extra_m:
            for request in self._results.collisionRequests:
                request.security_margin = self.required_m + extra_m
            self._extra_m = extra_m
        return not pin.computeCollisions(self._model, self._data, self._geometry, self._results, q, True)

    def use(self, pair: tuple[Body, Body], wanted: bool) -> None:
        """Takes a pair into the computation or leaves it out; nothing where this group does not have it."""
        k = self._index.get(_key(pair))
        if k is None:
            return
        (self._results.activateCollisionPair if wanted else self._results.deactivateCollisionPair)(k)
        self.watched[k] = wanted

    @property
    def active(self) -> list[tuple[Body, Body]]:
        """The pairs that are taken into the computation."""
        return [pair for pair, watched in zip(self.bodies, self.watched, strict=True) if watched]

    def move(self, thing: Body, placement: Any) -> None:
        """Moves a fixed body; nothing where no pair has it."""
        if _id(thing) in self._ids:
            self._geometry.geometryObjects[self._ids[_id(thing)]].placement = placement


def _id(body: Body) -> str:
    return f"{body.joint} {body.name} {id(body)}"


def _key(pair: tuple[Body, Body]) -> tuple[int, int]:
    return id(pair[0]), id(pair[1])


def measure_distance(first: Any, first_placement: Any, second: Any, second_placement: Any) -> float:
    """Signed distance of two shapes, m."""
    transforms = [coal.Transform3s(T.rotation, T.translation) for T in (first_placement, second_placement)]
    return float(coal.distance(first, transforms[0], second, transforms[1], coal.DistanceRequest(), coal.DistanceResult()))
