"""Errors of a joint that repeat with its angle. Compiled."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.effects.scene import Scene


def angle_wave(scene: Scene, order: Array, c: Array, s: Array) -> tuple[Array, Array]:
    """`angle_waves` of one wave for each joint: order, c and s (n,)."""
    return angle_waves(scene, order[None], c[None], s[None])


def angle_waves(scene: Scene, orders: Array, c: Array, s: Array) -> tuple[Array, Array]:
    """The sum of `c cos(order q) + s sin(order q)` per joint as the scene's windows show it, rad, and its second derivative, rad/s2.

    (N, n) each.

    Args:
        orders: (m, n), waves per turn.
        c, s: (m, n), rad.
    """
    if scene.q is None or scene.dq is None:
        raise ValueError("errors of joints need a scene with joints (see Effect.explain_lack)")
    q, dq = scene.past("wave q").before(scene.q, 1), scene.past("wave dq").before(scene.dq, 1)
    error, acceleration = _wave(q, dq, *(np.ascontiguousarray(x) for x in (orders, c, s)), scene.period, max(scene.window, scene.period))
    return error[-len(scene) :], acceleration[-len(scene) :]


@njit(cache=True)
def _wave(q: Array, dq: Array, orders: Array, c: Array, s: Array, period: float, window: float) -> tuple[Array, Array]:
    N, n = q.shape
    error = np.zeros((N, n))
    acceleration = np.zeros((N, n))
    for i in range(len(orders)):
        for j in range(n):
            if c[i, j] == 0.0 and s[i, j] == 0.0:
                continue
            order = orders[i, j]
            for k in range(N):
                rate = order * dq[k, j]
                growth = order * (dq[k, j] - dq[max(k - 1, 0), j]) / period
                x = 0.5 * rate * window
                visible = (np.sin(x) / x) ** 4 if abs(x) > 1e-3 else 1.0  # what cubic B-splines leave of a sine
                cos, sin = visible * np.cos(order * q[k, j]), visible * np.sin(order * q[k, j])
                wave = c[i, j] * cos + s[i, j] * sin
                error[k, j] += wave
                acceleration[k, j] += growth * (s[i, j] * cos - c[i, j] * sin) - rate * rate * wave
    return error, acceleration
