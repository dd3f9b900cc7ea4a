"""How a motion goes on after it was stopped in the middle: back onto its path where braking has left it, then along it, slowly at first.

The geometry of the path stays as it was planned; only the time along it passes more slowly until the planned speed is reached again.
"""

from __future__ import annotations

import math

import numpy as np

from core.array import Array
from core.errors import BadState

OFF_PATH = 0.02
"""How far from its path a robot may stand after braking, rad. It brakes along the tangent, so it is some 1e-3 rad; more means that
somebody has moved it."""
APPROACH_SPEED = 0.02
"""Joint speed of the way back onto the path, rad/s, in at least `LEAST_APPROACH_S`."""
LEAST_APPROACH_S = 0.1
BRAKING_S = 0.3
"""Within this time of the path the place is looked for where the robot stands, s; drives brake in less than 0.1 s."""
LEAST_RAMP_S = 0.5
"""Time at least in which the planned speed is reached again."""


def smooth_share(x: float | Array) -> Array:
    """From 0 at x = 0 to 1 at x = 1, with two derivatives zero at both ends."""
    return np.asarray(x**3 * (10.0 - 15.0 * x + 6.0 * x**2))


def place_on_path(path: Array, k: int, q: Array, period: float) -> int:
    """The index on a path (K, n), at or soon after k, that is nearest to q (n,).

    Raises:
        BadState: q is too far from all of them.
    """
    ahead = np.abs(path[k : k + max(2, round(BRAKING_S / period))] - q).max(axis=1)
    nearest = int(np.argmin(ahead))
    if not ahead[nearest] <= OFF_PATH:
        raise BadState("motion-moved-while-stopped", value=float(ahead[nearest]), limit=OFF_PATH)
    return k + nearest


def resume_path(path: Array, k: int, q: Array, period: float) -> Array:
    """The rest of a path from standstill at q.

    Args:
        path: (K, n), commanded joint positions, one a period, rad.
        k: index of the last one that was commanded before the robot braked.
        q: (n,), where it stands.
        period: s.

    Returns:
        (L, n), beginning with q: to the path, then along it up to its end.

    Raises:
        BadState: q is not near the path.
    """
    place = place_on_path(path, k, q, period)
    approach = _approach(q, path[place], period)
    left = len(path) - 1 - place
    if left == 0:
        return approach
    steps = _ramp_steps(path, place, period)
    steps = min(steps, left)  # of the path; twice as many periods, because the ramp's mean speed is half the planned one
    x = np.arange(1, 2 * steps + 1) / (2 * steps)
    travelled = 2 * steps * x**4 * (2.5 - 3.0 * x + x**2)  # integral of `smooth_share`
    return np.concatenate([approach, _between(path, place + travelled), path[place + steps + 1 :]])


def _approach(q: Array, there: Array, period: float) -> Array:
    """(L, n), from q to a place nearby."""
    away = float(np.abs(there - q).max())
    steps = math.ceil(max(LEAST_APPROACH_S, 1.875 * away / APPROACH_SPEED) / period)
    return q + np.outer(smooth_share(np.arange(steps + 1) / steps), there - q)


def _ramp_steps(path: Array, place: int, period: float) -> int:
    """Periods of the path over which its speed is reached again: gently against the accelerations that the path itself has."""
    speed = np.abs(path[min(place + 1, len(path) - 1)] - path[place]) / period
    acceleration = np.abs(np.diff(path, n=2, axis=0)).max(axis=0, initial=0.0) / period**2
    moving = speed > 1e-6
    ratio = float((speed[moving] / np.maximum(acceleration[moving], 1e-3)).max(initial=0.0))
    return math.ceil(0.5 * max(LEAST_RAMP_S, 8.0 * ratio) / period)


def _between(path: Array, at: Array) -> Array:
    """(L, n), the path at indices that are no whole numbers, by the cubic through each two with their mean slopes: its second differences
    stay as smooth as the path's."""
    last = len(path) - 1
    k = np.clip(np.floor(at).astype(int), 0, last - 1)
    x = (at - k)[:, None]
    slope = np.gradient(path, axis=0) if len(path) > 1 else np.zeros_like(path)
    start, end, begin, finish = path[k], path[k + 1], slope[k], slope[k + 1]
    return np.asarray(
        start * (2 * x**3 - 3 * x**2 + 1) + begin * (x**3 - 2 * x**2 + x) + end * (3 * x**2 - 2 * x**3) + finish * (x**3 - x**2)
    )
