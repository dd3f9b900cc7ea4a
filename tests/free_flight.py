"""Where a load flies that comes off anywhere along a motion, for the independent checker.

A rigid body that is released goes on with the velocity of its centre of mass, falls, and goes on turning at the rate that it had. Whether
its box gets into a protected zone is asked of the box itself, placed along the fall, every two milliseconds where it is near, until a
corner is on the floor. What happens after it has hit something is not predicted.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from tests.convex_distance import Convex, bounds, packed

LONGEST_FALL_S = 3.0
TICK_S = 0.002


def deepest_flight(
    load: Convex, in_sensor: Array, centre: Array, poses: Array, period: float, zone: Convex, gravity: Array, floor_z_m: float
) -> float:
    """Smallest distance of any flight to a zone, m; of flights that stay 0.1 m away from it only a bound; negative inside.

    Args:
        load: a box about its own origin, placed in the sensor frame by `in_sensor` (4, 4).
        centre: (3,), of mass, in the sensor frame, m.
        poses: (N, 4, 4), the sensor in the world, every `period` s.
        gravity: (3,), world, m/s2.
    """
    R, p = poses[:, :3, :3], poses[:, :3, 3]
    com = p + R @ centre
    velocity = np.gradient(com, period, axis=0)
    rate = np.zeros_like(velocity)
    turned = R[2:] @ np.swapaxes(R[:-2], 1, 2) if len(R) > 2 else np.zeros((0, 3, 3))
    rate[1:-1] = np.stack(
        [turned[:, 2, 1] - turned[:, 1, 2], turned[:, 0, 2] - turned[:, 2, 0], turned[:, 1, 0] - turned[:, 0, 1]], axis=1
    ) / (4.0 * period)
    boxes = poses @ in_sensor
    radius = float(np.linalg.norm(load.points, axis=1).max() + np.linalg.norm(in_sensor[:3, 3] - centre))
    middle = 0.5 * (zone.corners.min(axis=0) + zone.corners.max(axis=0))
    half = 0.5 * (zone.corners.max(axis=0) - zone.corners.min(axis=0))
    return float(_deepest(packed([load, zone]), boxes, com, velocity, rate, load.points, radius, middle, half, gravity, floor_z_m))


@njit(cache=True)
def _turn(rate, t):  # type: ignore[no-untyped-def]  # numba infers them
    """Rotation by a constant rate for t (Rodrigues)."""
    speed = np.sqrt(rate[0] ** 2 + rate[1] ** 2 + rate[2] ** 2)
    R = np.eye(3)
    if speed * t < 1e-12:
        return R
    x, y, z = rate[0] / speed, rate[1] / speed, rate[2] / speed
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return R + np.sin(speed * t) * K + (1.0 - np.cos(speed * t)) * (K @ K)


@njit(cache=True)
def _deepest(bodies, boxes, com, velocity, rate, corners, radius, middle, half, gravity, floor_z):  # type: ignore[no-untyped-def]  # numba infers them
    """See `deepest_flight`: a ball round the load against a box round the zone first, then the bodies themselves.

    From a distance d the load needs some time to come nearer than the least distance so far: no flight is looked at before.
    """
    least, still = 0.1, np.eye(4)
    g = np.sqrt(gravity[0] ** 2 + gravity[1] ** 2 + gravity[2] ** 2)
    placed = np.eye(4)
    for m in range(len(com)):
        v, w = velocity[m], rate[m]
        speed = np.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2) + radius * np.sqrt(w[0] ** 2 + w[1] ** 2 + w[2] ** 2)
        t = 0.0
        while t < LONGEST_FALL_S:
            at = com[m] + v * t + 0.5 * t * t * gravity
            if at[2] < floor_z:
                break
            square = 0.0
            for r in range(3):
                square += max(abs(at[r] - middle[r]) - half[r], 0.0) ** 2
            away = np.sqrt(square) - radius
            if away <= least:
                R = _turn(w, t)
                placed[:3, :3] = R @ np.ascontiguousarray(boxes[m][:3, :3])
                placed[:3, 3] = at + R @ (boxes[m][:3, 3] - com[m])
                lowest = np.inf
                for c in range(len(corners)):
                    height = placed[2, 0] * corners[c, 0] + placed[2, 1] * corners[c, 1] + placed[2, 2] * corners[c, 2]
                    lowest = min(lowest, height + placed[2, 3])
                if t > 0.0 and lowest < floor_z:
                    break
                away, _ = bounds(bodies, 0, 1, placed, still)
                least = min(least, away)
            room, u = max(away - least, 0.0), speed + g * t
            t += max((np.sqrt(u * u + 2.0 * g * room) - u) / g, TICK_S)
    return least
