"""The guard's checks that need no distance query, compiled into one pass over the robot state."""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.control.speed import fastest_point


class GuardStop(IntEnum):
    """What is wrong; the order is that of the checks."""

    NONE = 0
    NOT_FINITE = 1
    TARGET_NOT_FINITE = 2
    STALE = 3
    LATE = 4
    POSITION = 5
    TARGET_POSITION = 6
    JOINT_SPEED = 7
    COMMANDED_JOINT_SPEED = 8
    SPEED = 9
    COMMANDED_SPEED = 10
    WRENCH = 11
    TRACKING = 12


class Numbers(NamedTuple):
    """What the checks compare with; also what compiled code is given.

    Args:
        period, late: shortest and longest time between two states is half of the one and all of the other, s.
        speed: Cartesian limit, m/s.
        speed_factor: by which measured and commanded speeds may exceed their limits.
        position_tolerance: by which measured joint positions may be past their limits, rad.
        tracking: largest distance of a joint from its command, rad.
        reaction: time until braking can begin, s.
        lower, upper, velocity, acceleration: (n,) joint limits.
        load: (6,) largest wrench.
        reach: (n,) motion bound of the collision model per joint angle, m/rad.
    """

    period: float
    late: float
    speed: float
    speed_factor: float
    position_tolerance: float
    tracking: float
    reaction: float
    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array
    load: Array
    reach: Array


class Findings(NamedTuple):
    """What the checks leave behind, filled in place.

    Args:
        value: (1,) what was found wrong.
        speed: (1,) Cartesian speed of the fastest point as measured, m/s.
        stop: (n,) where the robot stands still after the reaction time and braking, all joints in proportion, rad.
        known_q: (2, n) configurations whose exact margins are known: one for today's distance, one for that of the
            predicted stop.
        known_margin: (2,), m; -inf where none is known.
        certified: (2,) margins that hold at `q` and at `stop` for certain, m.
    """

    value: Array
    speed: Array
    stop: Array
    known_q: Array
    known_margin: Array
    certified: Array


@njit(cache=True)
def _finite(values: Array) -> bool:
    for value in values:  # noqa: SIM110 - compiled: Numba knows no `any` of a generator
        if not np.isfinite(value):
            return False
    return True


@njit(cache=True)
def _outside(q: Array, lower: Array, upper: Array, tolerance: float) -> int:
    for i in range(len(q)):
        if q[i] < lower[i] - tolerance or q[i] > upper[i] + tolerance:
            return i
    return -1


@njit(cache=True)
def _beyond(values: Array, limits: Array, factor: float) -> int:
    for i in range(len(values)):
        if abs(values[i]) > factor * limits[i]:
            return i
    return -1


@njit(cache=True)
def _motion(reach: Array, q_a: Array, q_b: Array) -> float:
    """`CollisionModel.motion_bound`."""
    bound = 0.0
    for i in range(len(reach)):
        bound += abs(q_b[i] - q_a[i]) * reach[i]
    return bound


@njit(cache=True)
def _check(  # noqa: PLR0911, PLR0912 - one return per fault, in the order of `Fault`
    placements: Array,
    axes: Array,
    joint: NDArray[np.int64],
    local: Array,
    numbers: Numbers,
    found: Findings,
    dt: float,
    q: Array,
    dq: Array,
    q_cmd: Array,
    wrench: Array,
    target: Array,
) -> tuple[int, int]:
    """The first fault and the joint, point or channel it is in; without one, 0 and the fastest point. dt is NaN for the first state."""
    n = len(q)
    if not (_finite(q) and _finite(dq) and _finite(q_cmd) and _finite(wrench)):
        return 1, 0
    if not _finite(target):
        return 2, 0
    found.value[0] = dt
    if dt < 0.5 * numbers.period:
        return 3, 0
    if dt > numbers.late:
        return 4, 0
    i = _outside(q, numbers.lower, numbers.upper, numbers.position_tolerance)
    if i >= 0:
        found.value[0] = q[i]
        return 5, i
    i = _outside(target, numbers.lower, numbers.upper, 1e-9)
    if i >= 0:
        found.value[0] = target[i]
        return 6, i
    i = _beyond(dq, numbers.velocity, numbers.speed_factor)
    if i >= 0:
        found.value[0] = dq[i]
        return 7, i
    step = (target - q_cmd) / numbers.period
    i = _beyond(step, numbers.velocity, numbers.speed_factor)
    if i >= 0:
        found.value[0] = step[i]
        return 8, i
    speed, fastest = fastest_point(placements, axes, joint, local, q, dq)
    found.value[0] = found.speed[0] = speed
    if speed > numbers.speed_factor * numbers.speed:
        return 9, fastest
    speed, k = fastest_point(placements, axes, joint, local, q_cmd, step)
    found.value[0] = speed
    if speed > numbers.speed_factor * numbers.speed:
        return 10, k
    for c in range(6):
        if abs(wrench[c]) >= numbers.load[c]:
            found.value[0] = wrench[c]
            return 11, c
    braking = 0.0  # time
    for j in range(n):
        if abs(q[j] - q_cmd[j]) > numbers.tracking:
            found.value[0] = q[j] - q_cmd[j]
            return 12, j
        braking = max(braking, abs(dq[j]) / numbers.acceleration[j])
    for j in range(n):
        found.stop[j] = q[j] + dq[j] * (numbers.reaction + 0.5 * braking)
    found.certified[0] = found.known_margin[0] - _motion(numbers.reach, found.known_q[0], q)
    found.certified[1] = found.known_margin[1] - _motion(numbers.reach, found.known_q[1], found.stop)
    return 0, fastest
