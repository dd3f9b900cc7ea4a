"""One period of a rotation about a sensor axis through the sensor origin, compiled."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.control.sns_kernel import _sns_step
from core.control.speed import fastest_point
from core.robot.chain import _forward, _jacobian
from core.robot.rotations import pose_error

GAIN = 100.0
"""Of the pose error, 1/s: what integrating velocities leaves in each period does not add up, some 10 nm at most."""


@njit(cache=True)
def _rotation_step(
    placements: Array,
    axes: Array,
    q: Array,
    dq: Array,
    axis: int,
    start: Array,
    angle: float,
    rate: float,
    lower: Array,
    upper: Array,
    velocity: Array,
    acceleration: Array,
    joint: NDArray[np.int64],
    local: Array,
    speed_limit: float,
    T: float,
    out: Array,
) -> float:
    """Fills the joint velocities of the next period, returns the share of the task they achieve."""
    now = _forward(placements, axes, q)
    about = np.eye(3)
    i, k = (axis + 1) % 3, (axis + 2) % 3
    about[i, i] = about[k, k] = np.cos(angle)
    about[k, i] = np.sin(angle)
    about[i, k] = -about[k, i]
    x = np.empty(6)
    pose_error(now[:3, :3].copy(), now[:3, 3], np.ascontiguousarray(start[:3, :3]) @ about, start[:3, 3], x)
    x *= GAIN
    x[3 + axis] += rate
    # where the arm is in the middle of the period, else what a joint gains on the way out it does not lose on the way back
    J = _jacobian(placements, axes, q + 0.5 * T * dq)
    s = _sns_step(J, q, dq, x, lower, upper, velocity, acceleration, T, out)
    fastest, _ = fastest_point(placements, axes, joint, local, q, out)
    if s > 0.0 and fastest > speed_limit:
        s *= speed_limit / fastest
        s *= _sns_step(J, q, dq, s * x, lower, upper, velocity, acceleration, T, out)
    if s == 0.0 and rate != 0.0:  # braking along the path: what is left of the rate
        left = 0.0
        for j in range(len(q)):
            left += J[3 + axis, j] * out[j]
        s = min(max(left / rate, 0.0), 1.0)
    return float(s)
