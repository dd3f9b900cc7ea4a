"""A wide-band motion of all joints round one configuration: as large as limits and room allow, checked at every tick."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import NoPath
from core.planning.certificate import is_clear
from core.planning.pair_margins import PairMargins
from core.planning.rotation_room import SHARE
from core.planning.start_configuration import LIMIT_MARGIN_RAD
from core.planning.throw import ThrowCheck
from core.planning.timing import MotionLimits, limit_usage
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory
from core.robot.watched_pairs import ROOM_M

ACCELERATION_SHARE = 0.6
"""Of the joints' acceleration limits: such a motion shakes the arm for many seconds."""
SHRINK = 0.8
_TRIES = 12


def fit_wave(cell: Cell, robot: RobotModel, collision: CollisionModel, q: Array, shape: Array, period: float) -> JointTrajectory:
    """The trajectory `q + s shape` with the largest s that keeps every limit.

    Args:
        q: (n,), where it begins and ends, rad.
        shape: (N, n), rad per unit of s, zero and at rest at both ends.

    Raises:
        NoPath: a thousandth of the first try would still leave the limits or the room.
    """
    limits = MotionLimits.of_cell(cell, robot, collision)
    limits = replace(
        limits,
        velocity=SHARE * limits.velocity,
        acceleration=ACCELERATION_SHARE * limits.acceleration,
        cartesian_speed_m_s=SHARE * limits.cartesian_speed_m_s,
    )
    small = 1e-3
    s = small / limit_usage(JointTrajectory(period, q + small * shape), robot, replace(limits, acceleration=np.full(robot.n, np.inf)))
    s = min(s, float((limits.acceleration / np.abs(np.diff(shape, 2, axis=0)).max(axis=0)).min()) * period**2)
    margins, throw = PairMargins(collision), ThrowCheck(cell)
    for _ in range(_TRIES):
        trajectory = JointTrajectory(period, q + s * shape)
        if _is_allowed(trajectory, robot, collision, limits, margins, throw):
            return trajectory
        s *= SHRINK
    raise NoPath("planning-no-room-for-wave", swing_rad=s * np.abs(shape).max())


def _is_allowed(
    trajectory: JointTrajectory, robot: RobotModel, collision: CollisionModel, limits: MotionLimits, margins: PairMargins, throw: ThrowCheck
) -> bool:
    """Joint limits, speeds, accelerations, distances and the flight of a load that comes off."""
    q = trajectory.q
    if ((q < robot.lower + LIMIT_MARGIN_RAD) | (q > robot.upper - LIMIT_MARGIN_RAD)).any():
        return False
    within = limit_usage(trajectory, robot, limits) <= 1.0
    return within and is_clear(margins, q, ROOM_M) and _throws_nothing(trajectory, robot, collision, throw)


def _throws_nothing(trajectory: JointTrajectory, robot: RobotModel, collision: CollisionModel, throw: ThrowCheck) -> bool:
    """Whether a load that comes off, at whatever moment, stays out of the zones."""
    return throw.into_zone(collision.payload_box, robot.sensor_poses(trajectory.q), trajectory.period) is None
