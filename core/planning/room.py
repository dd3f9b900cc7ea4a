"""Where a path may go: within the joint limits, with every required distance and something to spare."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.collision import CollisionModel
from core.planning.certificate import is_clear
from core.planning.pair_margins import PairMargins
from core.robot import RobotModel

Array = NDArray[np.float64]

LIMIT_ROOM_RAD = 0.02
"""Paths keep this far from the joint limits, except where start or goal is closer."""

_RISE = 0.05
"""How fast the wanted margin rises with the bound of the motion from a tight end; that bound is far larger than what leads away."""


class Room:
    """Where a path between given ends may go.

    Args:
        ends: (K, n), start and goals.
        spare_m: wanted margin. Near an end that has less, less is asked: half of that end's margin, rising with the distance from it.
    """

    def __init__(self, robot: RobotModel, collision: CollisionModel, ends: Array, spare_m: float) -> None:
        self.margins = PairMargins(collision)
        self._collision = collision
        self.lower = np.minimum(robot.lower + LIMIT_ROOM_RAD, ends.min(axis=0))
        self.upper = np.maximum(robot.upper - LIMIT_ROOM_RAD, ends.max(axis=0))
        self._spare_m = spare_m
        self._tight = [(q, margin) for q in ends if (margin := collision.room(q)) < 2.0 * spare_m]

    def spare(self, q: Array) -> float:
        """Margin that is wanted at q (n,), m."""
        moved = self._collision.motion_bound
        return min([self._spare_m, *(0.5 * margin + _RISE * moved(end, q) for end, margin in self._tight)])

    def has(self, q: Array) -> bool:
        """Whether the robot may be at q (n,)."""
        within = bool((q >= self.lower).all() and (q <= self.upper).all())
        return within and self._collision.is_free(q) and self._collision.room(q) >= self.spare(q)

    def has_all(self, q: Array) -> bool:
        """Whether the robot may move along the polyline q (N, n); what is cheap to refuse is refused first."""
        if not ((q >= self.lower).all() and (q <= self.upper).all()):
            return False
        free = self._collision.is_free
        middles = 0.5 * (q[:-1] + q[1:])
        return all(free(row) for row in (*q, *middles)) and is_clear(self.margins, q, self.spare)
