"""Eq. (7): limits on joint positions, velocities and accelerations merged into bounds on the joint velocity of the next
period.

The paper's bound `sqrt(2 A (Q_max - q))` is the braking distance in continuous time. In discrete time a joint that
follows it passes its limit or has to brake harder than A in the last periods. Here the exact discrete braking distance
takes its place: with v held for one period T_s and then lowered by `A T_s` each period, the joint travels `T_s (v + (v
- A T_s) + ...)`; the bound is the largest v for which that fits into `Q_max - q`. It contains the paper's first term
`(Q_max - q) / T_s` (the case v <= A T_s) and tends to the third for a small T_s. Braking at A is then always among the
allowed velocities, so position and acceleration limits hold together, tick to tick.
"""

from __future__ import annotations

from typing import NamedTuple, Self

import numpy as np
from numba import njit

from core.array import Array
from core.cell.cell import Cell
from core.robot.model import RobotModel

ROUNDING = 1e-9
"""Position limits are drawn in by this much (rad), so that rounding cannot carry a joint past them."""


class JointLimits(NamedTuple):
    """Limits of n joints.

    Args:
        lower, upper: (n,) Q_min and Q_max, rad.
        velocity: (n,) V_max, rad/s.
        acceleration: (n,) A_max, rad/s2.
    """

    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array

    @classmethod
    def of(cls, cell: Cell, robot: RobotModel) -> Self:
        """Position limits from the URDF; velocities from the cell, or the URDF where the cell gives none; accelerations from the cell."""
        given = cell.robot.velocity_rad_s
        velocity = robot.velocity if given is None else np.minimum(robot.velocity, np.array(given))
        return cls(robot.lower, robot.upper, velocity, np.array(cell.robot.acceleration_rad_s2))


@njit(cache=True)
def _reachable(distance: float, A: float, T: float) -> float:
    """Largest velocity from which a joint can still stop within `distance`, when it changes by at most A T per period."""
    d = distance - ROUNDING
    if d <= 0.0:
        return 0.0
    n = np.floor(0.5 * (np.sqrt(1.0 + 8.0 * d / (A * T * T)) - 1.0))
    return float((d / T + 0.5 * A * T * n * (n + 1.0)) / (n + 1.0))


@njit(cache=True)
def _velocity_bounds(
    q: Array,
    dq: Array,
    lower: Array,
    upper: Array,
    velocity: Array,
    acceleration: Array,
    T: float,
    lo: Array,
    hi: Array,
) -> None:
    for i in range(len(q)):
        A, V = acceleration[i], velocity[i]
        slowest, fastest = dq[i] - A * T, dq[i] + A * T
        lo[i] = max(-_reachable(q[i] - lower[i], A, T), -V, slowest)
        hi[i] = min(_reachable(upper[i] - q[i], A, T), V, fastest)
        if lo[i] > hi[i]:  # past a limit, or too fast for it: brake
            lo[i] = hi[i] = min(max(0.0, slowest), fastest)


def velocity_bounds(q: Array, dq: Array, limits: JointLimits, period: float) -> tuple[Array, Array]:
    """Eq. (7) with acceleration limits: lowest and highest joint velocities (n,), (n,) allowed in the next period,
    rad/s.

    Never empty: a joint that is past a limit or too fast to keep it gets the one velocity that brakes it at A_max.

    Args:
        q: (n,) joint positions now, rad.
        dq: (n,) joint velocities of the period that ends now, rad/s.
        limits: of the joints.
        period: T_s, s.
    """
    lo, hi = np.empty(len(q)), np.empty(len(q))
    _velocity_bounds(q, dq, *limits, period, lo, hi)
    return lo, hi
