"""Whether a configuration leaves room for a whole rotation about a sensor axis through the sensor origin.

Joint velocities of least norm make the path in joint space depend on the angle alone, not on the timing: dq/dangle = J^+ [0; axis]. It is
what SNS (Algorithm 7) follows as long as no joint is at a limit, which is what is asked for here.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto

import numpy as np
from numba import njit

from core.array import Array
from core.cell.cell import Cell
from core.planning.timing import MotionLimits
from core.robot.chain import Chain, fill_jacobian, joint_frames
from core.robot.collision import CollisionModel
from core.robot.inverse_kinematics import _fill_damped_step
from core.robot.model import RobotModel
from core.robot.point_speed import point_speeds
from core.robot.rotations import exponential, pose_error
from core.robot.trajectory import AngularProfile

SHARE = 0.95
"""Of the velocity, acceleration and Cartesian speed limits that a rotation may use, so that it runs unscaled."""

_STEP_RAD = 0.025
_DAMPING = 1e-10


class Obstruction(Enum):
    """Why a rotation cannot be done from a configuration."""

    JOINT_LIMIT = auto()
    JOINT_SPEED = auto()
    JOINT_ACCELERATION = auto()
    CARTESIAN_SPEED = auto()


@dataclass(frozen=True)
class Turn:
    """An angular profile as the limits see it: a grid of angles with the fastest rate that occurs near each.

    Args:
        axis: (3,), unit vector in the sensor frame.
        angle: (K,), evenly spaced over the angles of the profile, rad.
        start: index of the angle 0.
        rate: (K,), largest |rate| within one step of the angle, rad/s.
        acceleration: largest angular acceleration, rad/s2.
    """

    axis: Array
    angle: Array
    start: int
    rate: Array
    acceleration: float

    @classmethod
    def of(cls, profile: AngularProfile, axis: Array) -> Turn:
        """The turn about a unit vector (3,) of the sensor frame."""
        low, high = min(profile.angle.min(), 0.0), max(profile.angle.max(), 0.0)
        below, above = (int(np.ceil(end / _STEP_RAD)) for end in (-low, high))
        angle = _STEP_RAD * np.arange(-below, above + 1, dtype=np.float64)
        nearest = np.rint(profile.angle / _STEP_RAD).astype(int) + below
        rate = np.zeros(len(angle))
        np.maximum.at(rate, nearest, np.abs(profile.rate))
        padded = np.concatenate((rate[:1], rate, rate[-1:]))
        rate = np.maximum(np.maximum(padded[:-2], padded[1:-1]), padded[2:])
        return cls(axis, angle, below, rate, float(np.abs(np.diff(profile.rate)).max()) / profile.period)


@njit(cache=True)
def _track(placements: Array, axes: Array, q0: Array, axis: Array, angle: Array, start: int, q: Array, dq: Array) -> bool:
    """Fills q and dq = dq/dangle (K, n) along the rotation; False where the joints cannot follow."""
    n = len(q0)
    R, p = np.empty((n + 1, 3, 3)), np.empty((n + 1, 3))
    J, A = np.empty((6, n)), np.empty((6, 6))
    e, y, step = np.empty(6), np.empty(6), np.empty(n)
    twist = np.zeros(6)
    twist[3:] = axis
    joint_frames(placements, axes, q0, R, p)
    origin, R0 = p[n].copy(), R[n].copy()
    turn = np.empty((3, 3))
    for direction in (1, -1):
        here = q0.copy()
        k = start
        while 0 <= k < len(angle):
            exponential(angle[k] * axis, turn)
            goal = R0 @ turn
            joint_frames(placements, axes, here, R, p)  # back onto the task
            pose_error(R[n], p[n], goal, origin, e)
            fill_jacobian(R, p, axes, J)
            _fill_damped_step(J, e, _DAMPING, A, y, step)
            for j in range(n):
                here[j] += step[j]
            joint_frames(placements, axes, here, R, p)
            pose_error(R[n], p[n], goal, origin, e)
            if not np.max(np.abs(e)) < 1e-5:
                return False
            fill_jacobian(R, p, axes, J)
            _fill_damped_step(J, twist, _DAMPING, A, y, step)
            q[k], dq[k] = here, step
            if np.max(np.abs(step)) > 50.0:
                return False
            width = angle[1] - angle[0] if len(angle) > 1 else 0.0
            middle = here + 0.5 * direction * width * step
            joint_frames(placements, axes, middle, R, p)
            fill_jacobian(R, p, axes, J)
            _fill_damped_step(J, twist, _DAMPING, A, y, step)
            for j in range(n):
                here[j] += direction * width * step[j]
            k += direction
    return True


def rotation_path(chain: Chain, q: Array, turn: Turn) -> tuple[Array, Array] | None:
    """Joint positions (K, n) at every angle of the turn that starts at q (n,), and dq/dangle (K, n); None at a singularity."""
    path, slope = np.empty((len(turn.angle), len(q))), np.empty((len(turn.angle), len(q)))
    start = np.ascontiguousarray(q, dtype=float)
    followed = _track(chain.placements, chain.axes, start, turn.axis, turn.angle, turn.start, path, slope)
    return (path, slope) if followed else None


class RotationCheck:
    """Room for one rotation: joint limits, velocities, accelerations and the Cartesian speed of every point."""

    def __init__(self, cell: Cell, robot: RobotModel, collision: CollisionModel, turn: Turn, limits: tuple[Array, Array]) -> None:
        self._robot = robot
        self._turn = turn
        self._lower, self._upper = limits
        self._limits = MotionLimits.of_cell(cell, robot, collision)

    def __call__(self, q: Array) -> Array | Obstruction:
        """The path in joint space (K, n) of the rotation that starts at q (n,), or why there is none."""
        found = rotation_path(self._robot.chain, q, self._turn)
        if found is None:
            return Obstruction.JOINT_SPEED  # a singularity
        path, slope = found
        turn, limits = self._turn, self._limits
        if ((path < self._lower) | (path > self._upper)).any():
            return Obstruction.JOINT_LIMIT
        rate = turn.rate[:, None]
        if (np.abs(slope) * rate > SHARE * limits.velocity).any():
            return Obstruction.JOINT_SPEED
        curvature = np.gradient(slope, turn.angle, axis=0) if len(turn.angle) > 1 else np.zeros_like(slope)
        if (np.abs(slope) * turn.acceleration + np.abs(curvature) * rate**2 > SHARE * limits.acceleration).any():
            return Obstruction.JOINT_ACCELERATION
        speeds = point_speeds(self._robot.chain, limits.points, path, slope * rate)
        if speeds.max() > SHARE * limits.cartesian_speed_m_s * (1.0 + 1e-9):
            return Obstruction.CARTESIAN_SPEED
        return path
