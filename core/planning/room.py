"""Where a path may go: within the joint limits, with every required distance and something to spare, where the joints can hold the load,
and where it may come off."""

from __future__ import annotations

import numpy as np

from core.array import Array, interpolate
from core.planning.certificate import is_clear
from core.planning.joint_torques import HOLDING_SHARE, JointTorques
from core.planning.pair_margins import PairMargins
from core.planning.throw import ThrowCheck
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

LIMIT_ROOM_RAD = 0.02
"""Paths keep this far from the joint limits, except where start or goal is closer."""

BESIDE = 4.0
"""How far beside a zone a load falls that comes off at rest, in wanted margins: a slow motion throws it no farther than these 2 cm."""

_STEP_RAD = 0.04
"""Between the configurations of a motion at which the load's weight and its fall are looked at."""

_RISE = 0.05
"""How fast the wanted margin rises with the bound of the motion from a tight end; that bound is far larger than what leads away."""


class Room:
    """Where a path between given ends may go.

    Args:
        throws: of the cell as it is now.
        ends: (K, n), start and goals.
        spare_m: wanted margin. Near an end that has less, less is asked: half of that end's margin, rising with the distance from it.
        torques: with the load, which the joints can hold everywhere, as well as at the ends at least; None where they are not to be judged.
    """

    def __init__(
        self,
        robot: RobotModel,
        collision: CollisionModel,
        throws: ThrowCheck,
        ends: Array,
        spare_m: float,
        torques: JointTorques | None = None,
    ) -> None:
        self.margins = PairMargins(collision)
        self._collision = collision
        self.lower = np.minimum(robot.lower + LIMIT_ROOM_RAD, ends.min(axis=0))
        self.upper = np.maximum(robot.upper - LIMIT_ROOM_RAD, ends.max(axis=0))
        self._spare_m = spare_m
        self._robot, self._throws, self._torques = robot, throws, torques
        self._holding_share = HOLDING_SHARE if torques is None else max(HOLDING_SHARE, torques.holding_share(ends))
        self._beside_m = min(BESIDE * spare_m, 0.5 * self._drop_m(ends))
        self._tight = [(q, margin) for q in ends if (margin := collision.room(q)) < 2.0 * spare_m]

    def spare(self, q: Array) -> float:
        """Margin that is wanted at q (n,), m."""
        moved = self._collision.motion_bound
        return min([self._spare_m, *(0.5 * margin + _RISE * moved(end, q) for end, margin in self._tight)])

    def has(self, q: Array) -> bool:
        """Whether the robot may be at q (n,)."""
        within = bool((q >= self.lower).all() and (q <= self.upper).all())
        return within and self._collision.is_free(q) and self._collision.room(q) >= self.spare(q) and self._bears_load(q[None])

    def has_all(self, q: Array) -> bool:
        """Whether the robot may move along the polyline q (N, n); what is cheap to refuse is refused first."""
        if not ((q >= self.lower).all() and (q <= self.upper).all()):
            return False
        free = self._collision.is_free
        middles = 0.5 * (q[:-1] + q[1:])
        return all(free(row) for row in (*q, *middles)) and self._bears_load(_dense(q)) and is_clear(self.margins, q, self.spare)

    def _bears_load(self, q: Array) -> bool:
        """Whether the joints can hold the load at q (N, n), and it falls beside the zones where it comes off."""
        return self._falls_beside(q) and (self._torques is None or self._torques.holding_share(q) <= self._holding_share)

    def _falls_beside(self, q: Array) -> bool:
        """Whether a load that comes off at rest anywhere at q (N, n) falls beside the zones."""
        return self._drop_m(q) >= self._beside_m

    def _drop_m(self, q: Array) -> float:
        """How near to a zone a load falls that comes off at rest anywhere at q (N, n), m; negative where it falls into one."""
        drop = self._throws.drop(self._collision.payload_box, self._robot.sensor_poses(q))
        return np.inf if drop is None else drop.distance_m


def _dense(q: Array) -> Array:
    """The polyline q (N, n), N >= 2, with rows at most `_STEP_RAD` rad apart."""
    along = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(q, axis=0), axis=1))))
    at = np.unique(np.concatenate((along, np.linspace(0.0, along[-1], 1 + int(np.ceil(along[-1] / _STEP_RAD))))))
    return interpolate(at, along, q)
