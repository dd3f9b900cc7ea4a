"""Configurations that put a sensor axis along gravity at the vertices of a grid, with what Eq. (6) says of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.planning.grid import Postures
from core.planning.link_room import LinkRoom
from core.planning.room_bound import RoomBound
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


class Candidates:
    """Solutions of the inverse kinematics, one per row; their distances are computed as late as possible.

    What a row scores is known from above at once, and exactly once it has been `ranked`: before that its objective, score and clearance are
    NaN.

    Args:
        q: (N, n), rad.
        vertex: (N,), index of the vertex they belong to.
        manipulability: (N,), smallest over largest singular value of the Jacobian.
        tried: how many inverse kinematics problems were posed.
        rest: (N,), the score without the distances.
        bound: (N,), the score at most.
        travel: (N,), what the way there costs, in the unit of the score.
        evaluate: from joint positions (n,) to the smallest distance to obstacles, zones and the floor, m, that of links near their mount
            counted larger; and to what the distances add to the score.

    Attributes:
        objective: (N,), Eq. (6).
        score: (N,), the objective minus what the way there costs.
        clearance: (N,), the smallest distance, m.
    """

    def __init__(
        self,
        q: Array,
        vertex: NDArray[np.intp],
        manipulability: Array,
        tried: int,
        *,
        rest: Array,
        bound: Array,
        travel: Array,
        evaluate: Callable[[Array], tuple[float, float]],
    ) -> None:
        self.q, self.vertex, self.manipulability, self.tried = q, vertex, manipulability, tried
        self._rest, self._bound, self._travel, self._evaluate = rest, bound, travel, evaluate
        self.objective, self.score, self.clearance = (np.full(len(q), np.nan) for _ in range(3))

    def __len__(self) -> int:
        return len(self.q)

    def rank(self, above: float = -np.inf) -> Iterator[int]:
        """The rows with scores above a value, best first; of equal ones the first."""
        known: list[tuple[float, int]] = []
        for row in np.argsort(-self._bound, kind="stable"):
            while known and -known[0][0] > self._bound[row]:
                yield heappop(known)[1]
            if self._bound[row] <= above:
                break
            self._look_at(int(row))
            if self.score[row] > above:
                heappush(known, (-float(self.score[row]), int(row)))
        while known:
            yield heappop(known)[1]

    def _look_at(self, row: int) -> None:
        if np.isnan(self.score[row]):
            self.clearance[row], distance = self._evaluate(self.q[row])
            self.score[row] = self._rest[row] + distance
            self.objective[row] = self.score[row] + self._travel[row]


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
        self._bound = RoomBound(robot.chain, collision, self._room)
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
        """Given configurations (N, n) as candidates, all of them looked at."""
        candidates = self._evaluate(q, np.zeros(len(q), dtype=np.intp), len(q))
        for _ in candidates.rank():
            pass
        return candidates

    def _evaluate(self, q: Array, vertex: NDArray[np.intp], tried: int) -> Candidates:
        """Eq. (6) and the way there."""
        weights = self._weights
        manipulability = self._manipulability(q)
        travel = weights.travel_per_s * self._travel_seconds(q)
        rest = weights.manipulability * manipulability - travel
        bound = rest + weights.distance * self._bound.least(q)
        return Candidates(q, vertex, manipulability, tried, rest=rest, bound=bound, travel=travel, evaluate=self._look_around)

    def _look_around(self, q: Array) -> tuple[float, float]:
        distances = self._room.distances(q[None])
        least = self._room.normalise(distances).min(initial=1.0)
        return float(distances.min(initial=np.inf)), float(self._weights.distance * least)

    def _manipulability(self, q: Array) -> Array:
        if len(q) == 0:
            return np.zeros(0)
        sigma = np.linalg.svd(self._robot.sensor_jacobians(q), compute_uv=False)
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
