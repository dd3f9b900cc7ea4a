"""Whether a cell could have been solved: random configurations and random trees on the independent checker of the tests.

It shares no collision code, no kinematics and no path search with the planner; what a rotation has to be is asked of the planner's
`decoupling_profile`. Slow and without taste, with nothing to spare. That it finds nothing proves nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell, Payload
from core.planning.settings import Timing
from core.planning.stops import PROCEDURE
from core.robot.decoupling import decoupling_profile
from tests.independent_checker import IndependentChecker

CANDIDATES = 4000
PERIOD_S = 0.001
_STRIDE = 10  # periods of a rotation between two configurations that are looked at
_STEPS = 30
_ALIGNED = 1e-6
_TRACKED = 1e-5
_EDGE_RAD = 0.04
_BRANCH_RAD = 0.4
_BRANCHES = 1500
_PATHS = 6
_DAMPING = 1e-3


@dataclass(frozen=True)
class Answer:
    """What was found for one pose: how many configurations pass every check, and whether one of them can be reached from home."""

    axis: str
    poses: int
    reachable: bool


class IndependentSearch:
    """Searches one cell with one payload."""

    def __init__(self, cell: Cell, payload_box: Box, payload: Payload | None, *, candidates: int = CANDIDATES, seed: int = 0) -> None:
        self._cell, self._box = cell, payload_box
        self._checker = IndependentChecker(cell, payload_box, payload)
        self._arm = self._checker.arm
        self._home = np.array(cell.robot.home_rad)
        self._candidates = candidates
        self._rng = np.random.default_rng([seed, 2024])
        self._low, self._high = np.maximum(self._arm.lower, self._home - np.pi), np.minimum(self._arm.upper, self._home + np.pi)
        speed = cell.limits.cartesian_speed_m_s
        self._turn = decoupling_profile(payload_box, cartesian_speed=speed, period=PERIOD_S, excursion=Timing().swing_rad)

    def answers(self) -> Iterator[Answer]:
        """One for each pose of the procedure, until one has no solution."""
        for axis in PROCEDURE.labels:
            answer = self.answer(axis)
            yield answer
            if not answer.reachable:
                return

    def answer(self, axis: str) -> Answer:
        """Looks for a configuration with that sensor axis along gravity that can be reached from home."""
        poses = 0
        for _ in range(self._candidates):
            q = self._aligned(axis)
            if q is None or not self._holds(q) or not (axis.endswith("-") or self._turns(q, axis)):
                continue
            poses += 1
            if self._reaches(q):
                return Answer(axis, poses, True)
            if poses == _PATHS:
                break
        return Answer(axis, poses, False)

    def _holds(self, q: Array) -> bool:
        """Whether the arm may stand at q (n,): distances, weight, and what comes off."""
        still = np.tile(q, (3, 1))
        return self._free(q) and self._checker.flights(still, PERIOD_S)[0] > 0.0

    def _free(self, q: Array) -> bool:
        return self._checker.is_free(q) and self._checker.weight_share(q) <= 1.0

    def _aligned(self, axis: str) -> Array | None:
        """A random configuration, turned until the sensor axis lies along gravity."""
        down = self._cell.gravity / np.linalg.norm(self._cell.gravity)
        k, sign = "xyz".index(axis[0]), 1.0 if axis[1] == "+" else -1.0
        q = self._rng.uniform(self._low, self._high)
        for _ in range(_STEPS):
            direction = sign * self._arm.sensor_poses(q[None])[0, :3, k]
            error = np.cross(direction, down)
            if direction @ down < 0.0 and np.linalg.norm(error) < 0.1:
                error = np.cross(direction, self._rng.normal(size=3))
            elif np.linalg.norm(error) < _ALIGNED:
                return q if (q >= self._arm.lower).all() and (q <= self._arm.upper).all() else None
            q = q + _solved((np.eye(3) - np.outer(direction, direction)) @ self._arm.jacobian(q)[3:], error)
        return None

    def _turns(self, q: Array, axis: str) -> bool:
        """Whether the rotation about that sensor axis can be made from q (n,), the sensor's origin kept."""
        start = self._arm.sensor_poses(q[None])[0]
        about = start[:3, "xyz".index(axis[0])]
        path = [q, q]
        for angle in self._turn.angle[::_STRIDE]:
            target = _rotation(about * angle) @ start[:3, :3]
            for _ in range(6):
                here = self._arm.sensor_poses(q[None])[0]
                error = np.concatenate((start[:3, 3] - here[:3, 3], _angle(target @ here[:3, :3].T)))
                if np.abs(error).max() < _TRACKED:
                    break
                q = q + _solved(self._arm.jacobian(q), error)
            else:
                return False
            path.append(q)
        return self._moves(np.array(path), _STRIDE * PERIOD_S)

    def _moves(self, path: Array, period: float) -> bool:
        """Whether the checker has nothing against a finished motion."""
        return not self._checker.check(path, period).violations

    def _reaches(self, goal: Array) -> bool:
        """Two trees of random branches, one from home and one from the goal (Kuffner and LaValle, ICRA 2000)."""
        trees: list[list[Array]] = [[self._home], [goal]]
        for _ in range(_BRANCHES):
            grown = self._extend(trees[0], self._rng.uniform(self._low, self._high))
            if grown is not None:
                nearest = min(trees[1], key=lambda q: float(np.linalg.norm(q - grown)))
                if self._edge(nearest, grown):
                    return True
            trees.reverse()
        return False

    def _extend(self, tree: list[Array], toward: Array) -> Array | None:
        nearest = min(tree, key=lambda q: float(np.linalg.norm(q - toward)))
        step = toward - nearest
        q = nearest + step * min(1.0, _BRANCH_RAD / float(np.linalg.norm(step)))
        if not self._edge(nearest, q):
            return None
        tree.append(q)
        return q

    def _edge(self, a: Array, b: Array) -> bool:
        """Whether the straight way between two configurations is free; the middle first."""
        parts = max(2, int(np.ceil(np.abs(b - a).max() / _EDGE_RAD)))
        order = sorted(range(1, parts + 1), key=lambda k: -(k & -k))
        return all(self._free(a + (b - a) * (k / parts)) for k in order)


def _solved(J: Array, error: Array) -> Array:
    """A step of damped least squares."""
    return np.asarray(J.T @ np.linalg.solve(J @ J.T + _DAMPING**2 * np.eye(len(J)), error))


def _rotation(vector: Array) -> Array:
    angle = float(np.linalg.norm(vector))
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = vector / angle
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * (K @ K))


def _angle(R: Array) -> Array:
    """The rotation vector of a small rotation."""
    return 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
