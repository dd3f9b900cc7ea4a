"""Configurations that put a sensor axis along gravity at the vertices of a grid, with what Eq. (6) says of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.planning.grid import Postures
from core.planning.link_room import LinkRoom
from core.planning.timing import MotionLimits
from core.robot.collision import CollisionModel
from core.robot.inverse_kinematics import solve_poses
from core.robot.model import RobotModel
from core.robot.point_speed import point_speeds


@dataclass(frozen=True)
class Weights:
    """What a good start configuration is.

    Args:
        distance: w_d of Eq. (6), of the least of the normalised distances to obstacles and zones (`LinkRoom.normalise`).
        manipulability: w_m of Eq. (6), of the smallest over the largest singular value of the Jacobian.
        travel_per_s: what one second of the way from the previous configuration costs, in the unit of the objective. Not in Eq. (6), but
            robot time is limited: 0.01 trades one second for 20 mm of the payload's room on an arm of 1 m reach.
    """

    distance: float = 1.0
    manipulability: float = 0.3
    travel_per_s: float = 0.01


@dataclass(frozen=True)
class Candidates:
    """Solutions of the inverse kinematics, one per row.

    Args:
        q: (N, n), rad.
        vertex: (N,), index of the vertex they belong to.
        objective: (N,), Eq. (6).
        score: (N,), the objective minus what the way there costs.
        clearance: (N,), smallest distance to obstacles, zones and the floor, m; that of links near their mount counted larger.
        manipulability: (N,), smallest over largest singular value of the Jacobian.
        tried: how many inverse kinematics problems were posed.
    """

    q: Array
    vertex: NDArray[np.intp]
    objective: Array
    score: Array
    clearance: Array
    manipulability: Array
    tried: int

    def __len__(self) -> int:
        return len(self.q)


class CandidateSearch:
    """Evaluates the configurations at the vertices of a grid (the inner loop of Algorithm 6).

    Args:
        limits: lower and upper joint limits (n,) that candidates keep.
        near: (n,), where the robot comes from, or None.
        diameter: of the workspace, m.
    """

    def __init__(
        self,
        cell: Cell,
        robot: RobotModel,
        collision: CollisionModel,
        *,
        limits: tuple[Array, Array],
        near: Array | None,
        diameter: float,
        weights: Weights,
    ) -> None:
        self._robot, self._collision = robot, collision
        self._lower, self._upper = limits
        self._near = near
        self._room = LinkRoom(robot, collision, limits, diameter)
        self._weights = weights
        self._motion = MotionLimits.of_cell(cell, robot, collision)

    def at(self, vertices: Array, postures: Postures, per_vertex: int) -> Candidates:
        """Candidates at vertices (V, 3): for each vertex inverse kinematics from its `per_vertex` nearest postures."""
        which = postures.nearest(vertices, per_vertex).ravel()
        vertex = np.repeat(np.arange(len(vertices)), per_vertex)
        solutions = solve_poses(
            self._robot.chain, self._lower, self._upper, postures.q[which], postures.align_with_gravity(which), vertices[vertex]
        )
        q = self._on_nearest_turn(solutions.q[solutions.solved])
        return self._evaluate(q, vertex[solutions.solved], len(which))

    def of(self, q: Array) -> Candidates:
        """Given configurations (N, n) as candidates."""
        return self._evaluate(q, np.zeros(len(q), dtype=np.intp), len(q))

    def _evaluate(self, q: Array, vertex: NDArray[np.intp], tried: int) -> Candidates:
        """Eq. (6) and the way there."""
        weights = self._weights
        distances = self._room.distances(q)
        clearance = distances.min(axis=1, initial=np.inf)
        manipulability = self._manipulability(q)
        least = self._room.normalise(distances).min(axis=1, initial=1.0)
        objective = weights.distance * least + weights.manipulability * manipulability
        score = objective - weights.travel_per_s * self._travel_seconds(q)
        return Candidates(q, vertex, objective, score, clearance, manipulability, tried)

    def _manipulability(self, q: Array) -> Array:
        if len(q) == 0:
            return np.zeros(0)
        sigma = np.linalg.svd(np.stack([self._robot.sensor_jacobian(row) for row in q]), compute_uv=False)
        return np.asarray(sigma[:, -1] / sigma[:, 0])

    def _travel_seconds(self, q: Array) -> Array:
        """(N,), about how long the straight way in joint space from `near` takes at the speed limits, s."""
        if self._near is None or len(q) == 0:
            return np.zeros(len(q))
        way = q - self._near
        total = np.zeros(len(q))
        for share in (1 / 6, 1 / 2, 5 / 6):
            speeds = point_speeds(self._robot.chain, self._motion.points, self._near + share * way, way)
            total += np.max(speeds, axis=1) / self._motion.cartesian_speed_m_s / 3
        return np.asarray(np.maximum(total, (np.abs(way) / self._motion.velocity).max(axis=1)))

    def _on_nearest_turn(self, q: Array) -> Array:
        """Joints that can turn more than once, moved by whole turns as near to `near` as their limits allow."""
        if self._near is None:
            return q
        full = 2.0 * np.pi
        turns = np.rint((self._near - q) / full)
        shifted = q + full * turns
        within = (shifted >= self._lower) & (shifted <= self._upper)
        return np.asarray(np.where(within, shifted, q))
