"""Whether a pose exists at all: many random configurations instead of a grid, nothing to spare, long searches for paths.

Slow and without taste; it only tells whether a cell that the planner refused could have been solved.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.errors import NoPath, NoStartConfiguration
from core.planning.candidate_checks import Attitude
from core.planning.certificate import is_clear
from core.planning.pair_margins import PairMargins
from core.planning.path import plan_path
from core.planning.rotation_room import Obstruction, RotationCheck, Turn
from core.planning.settings import Timing
from core.planning.start_configuration import find_start_configuration
from core.planning.stops import PROCEDURE
from core.planning.throw import ThrowCheck, loads_of
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile

CANDIDATES = 100_000
"""Random configurations per axis, 20 times what one round of Algorithm 6 looks at."""

_ALIGNING_STEPS = 12
_ALIGNED_RAD = 1e-4
_PATHS = 10
_PATH_ITERATIONS = 32_000


@dataclass(frozen=True)
class Answer:
    """What the search found for one axis: how many poses pass every check, and whether one of them can be reached from home."""

    axis: str
    poses: int
    reachable: bool


class BruteForce:
    """Searches one cell."""

    def __init__(self, cell: Cell, payload_box: Box, *, candidates: int = CANDIDATES, seed: int = 0) -> None:
        self._cell = cell
        self._robot = RobotModel.of_cell(cell)
        self._collision = CollisionModel(cell, self._robot, payload_box)
        self._margins = PairMargins(self._collision)
        self._throw = ThrowCheck(cell)
        self._box = payload_box
        self._home = np.array(cell.robot.home_rad)
        self._candidates = candidates
        self._rng = np.random.default_rng([seed, 161])

    def answer(self, axis: str) -> Answer:
        """Looks for a pose with that sensor axis along gravity that can be reached from home: the engine's own first, then random ones."""
        profile = self._profile(axis)
        if self._known(axis, profile):
            return Answer(axis, 1, True)
        poses = 0
        for q in self._poses(axis, profile):
            poses += 1
            if self._reaches(q):
                return Answer(axis, poses, True)
            if poses == _PATHS:
                break
        return Answer(axis, poses, False)

    def answers(self) -> Iterator[Answer]:
        """One for each pose of the procedure, until one has no solution."""
        for axis in PROCEDURE.labels:
            answer = self.answer(axis)
            yield answer
            if not answer.reachable:
                return

    def _known(self, axis: str, profile: AngularProfile | None) -> bool:
        try:
            found = find_start_configuration(
                self._cell, self._robot, self._collision, Attitude.of_axis(axis, profile), seed=17, near=self._home
            )
        except NoStartConfiguration:
            return False
        return self._reaches(found.q)

    def _reaches(self, q: Array) -> bool:
        try:
            plan_path(self._cell, self._robot, self._collision, self._home, q, iterations=_PATH_ITERATIONS)
        except NoPath:
            return False
        return True

    def _profile(self, axis: str) -> AngularProfile | None:
        if axis.endswith("-"):
            return None
        speed = self._cell.limits.cartesian_speed_m_s
        return decoupling_profile(self._box, cartesian_speed=speed, period=0.001, excursion=Timing().swing_rad)

    def _poses(self, axis: str, profile: AngularProfile | None) -> Iterator[Array]:
        """Random configurations that pass every check, with nothing to spare."""
        robot, collision = self._robot, self._collision
        unit = np.eye(3)["xyz".index(axis[0])]
        loads = loads_of(self._box, unit, profile)
        turns = None
        if profile is not None:
            turns = RotationCheck(self._cell, robot, collision, Turn.of(profile, unit), (robot.lower, robot.upper))
        for _ in range(self._candidates):
            q = self._aligned(unit if axis.endswith("+") else -unit)
            if q is None or not collision.is_free(q):
                continue
            pose = robot.sensor_pose(q)
            throw = self._throw.nearest(loads, pose.rotation, pose.position)
            if throw is not None and throw.distance_m < 0.0:
                continue
            path = q[None] if turns is None else turns(q)
            if not isinstance(path, Obstruction) and is_clear(self._margins, path):
                yield q

    def _aligned(self, axis: Array) -> Array | None:
        """A random configuration, turned by damped least squares until the sensor axis (3,) lies along gravity."""
        robot = self._robot
        q = self._rng.uniform(np.maximum(robot.lower, self._home - np.pi), np.minimum(robot.upper, self._home + np.pi))
        down = self._cell.gravity / np.linalg.norm(self._cell.gravity)
        for _ in range(_ALIGNING_STEPS):
            turn = np.cross(axis, robot.sensor_pose(q).rotation.T @ down)
            if np.linalg.norm(turn) < _ALIGNED_RAD and axis @ robot.sensor_pose(q).rotation.T @ down > 0.0:
                return np.asarray(q) if (q >= robot.lower).all() and (q <= robot.upper).all() else None
            J = (np.eye(3) - np.outer(axis, axis)) @ robot.sensor_jacobian(q)[3:]
            q = q + J.T @ np.linalg.solve(J @ J.T + 1e-6 * np.eye(3), turn)
        return None
