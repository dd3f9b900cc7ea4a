"""Times a path: as fast as joint velocities, joint accelerations and the Cartesian speed of every point allow, from rest to rest.

The time-optimal speed along the path switches its acceleration abruptly; sdot is therefore smoothed by a moving average over a short
window, which keeps the robot on the path. Every limit is then checked on the samples themselves, by finite differences.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.interpolate import PPoly

from core.array import Array
from core.cell.cell import Cell
from core.errors import NoPath
from core.planning.phase_plane import fastest_profile
from core.robot.bodies import SpeedPoints
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.point_speed import point_positions, point_speeds
from core.robot.trajectory import JointTrajectory

SMOOTHING_S = 0.12
"""Window of the moving average: the time in which the speed changes from one bound to the next."""

_GRID_RAD = 0.01
_GRID_PER_PIECE = 24
_ROUNDS = 8


@dataclass(frozen=True)
class MotionLimits:
    """What a trajectory must keep.

    Args:
        velocity, acceleration: (n,), rad/s and rad/s2.
        cartesian_speed_m_s: of every one of `points`.
    """

    velocity: Array
    acceleration: Array
    cartesian_speed_m_s: float
    points: SpeedPoints

    @classmethod
    def of_cell(cls, cell: Cell, robot: RobotModel, collision: CollisionModel) -> MotionLimits:
        """The cell's own limits."""
        velocity = robot.velocity if cell.robot.velocity_rad_s is None else np.array(cell.robot.velocity_rad_s)
        return cls(velocity, np.array(cell.robot.acceleration_rad_s2), cell.limits.cartesian_speed_m_s, collision.points)


def least_seconds(q: Array, robot: RobotModel, limits: MotionLimits, *, step: float = 0.05) -> float:
    """Lower bound of the time along the polyline q (N, n): at every place the speed that velocity and Cartesian limits allow, s."""
    sides = np.diff(q, axis=0)
    counts = 1 + (np.linalg.norm(sides, axis=1) / step).astype(int)
    side = np.repeat(np.arange(len(sides)), counts)
    within = np.arange(len(side)) - np.repeat(np.cumsum(counts) - counts, counts)
    middle = q[side] + ((within + 0.5) / counts[side])[:, None] * sides[side]
    moved = sides[side] / counts[side, None]
    return float(_slowness(middle, moved, robot, limits).sum())


def _slowness(q: Array, tangent: Array, robot: RobotModel, limits: MotionLimits) -> Array:
    """(N,), 1 / (largest sdot) at q (N, n) moving along tangent (N, n), from velocity and Cartesian speed."""
    cartesian = point_speeds(robot.chain, limits.points, q, tangent).max(axis=1) / limits.cartesian_speed_m_s
    return np.asarray(np.maximum(cartesian, (np.abs(tangent) / limits.velocity).max(axis=1)))


def time_curve(curve: PPoly, robot: RobotModel, limits: MotionLimits, *, period: float) -> JointTrajectory:
    """Trajectory along a smooth curve within the limits, which hold for the finite differences of its samples.

    Raises:
        NoPath: no timing keeps the limits.
    """
    s = _grid(curve.x)
    tangent, curvature = np.asarray(curve(s, 1)), np.asarray(curve(s, 2))
    ceiling = 1.0 / np.maximum(_slowness(np.asarray(curve(s)), tangent, robot, limits), 1e-6) ** 2
    x = fastest_profile(s, tangent, curvature, limits.acceleration, ceiling)
    slow = 1.0
    for _ in range(_ROUNDS):
        along = _smooth(_sample(s, x, period * slow), round(SMOOTHING_S / period))
        trajectory = JointTrajectory(period, np.asarray(curve(np.clip(along, 0.0, s[-1]))))
        excess = limit_usage(trajectory, robot, limits)
        if excess <= 1.0:
            return trajectory
        slow /= 1.0001 * excess
    raise NoPath("planning-no-timing", excess=excess, rounds=_ROUNDS)


def limit_usage(trajectory: JointTrajectory, robot: RobotModel, limits: MotionLimits) -> float:
    """Largest ratio to a limit, by finite differences of the samples.

    For accelerations it is the square root of the ratio: how much slower to go.
    """
    q, T = trajectory.q, trajectory.period
    q = np.concatenate((q[:1], q, q[-1:]))
    dq = np.diff(q, axis=0) / T
    moved = np.linalg.norm(np.diff(point_positions(robot.chain, limits.points, q), axis=0), axis=2) / T
    return float(
        max(
            (np.abs(dq) / limits.velocity).max(),
            np.sqrt((np.abs(np.diff(dq, axis=0)) / T / limits.acceleration).max(initial=0.0)),
            moved.max() / limits.cartesian_speed_m_s,
        )
    )


def _grid(breaks: Array) -> Array:
    """Grid over the pieces of a curve, finer where a piece is short (a tight corner)."""
    pieces = [np.linspace(a, b, max(_GRID_PER_PIECE, int((b - a) / _GRID_RAD)), endpoint=False) for a, b in pairwise(breaks)]
    return np.concatenate((*pieces, breaks[-1:]))


def _sample(s: Array, x: Array, period: float) -> Array:
    """s at every period for squared speeds x with constant acceleration between the grid points; the last sample is the end."""
    sdot = np.sqrt(x)
    ds = np.diff(s)
    t = np.concatenate(([0.0], np.cumsum(2.0 * ds / (sdot[:-1] + sdot[1:]))))
    u = np.diff(x) / (2.0 * ds)
    when = np.arange(int(np.ceil(t[-1] / period)) + 1) * period
    i = np.clip(np.searchsorted(t, when, side="right") - 1, 0, len(ds) - 1)
    tau = np.minimum(when, t[-1]) - t[i]
    return np.asarray(s[i] + sdot[i] * tau + 0.5 * u[i] * tau**2)


def _smooth(s: Array, window: int) -> Array:
    """s after a moving average with a Hann window of that many samples; longer by as many, at rest at both ends."""
    weights = np.hanning(window + 2)[1:-1]
    padded = np.concatenate((np.full(window - 1, s[0]), s, np.full(window - 1, s[-1])))
    return np.convolve(padded, weights / weights.sum(), mode="valid")
