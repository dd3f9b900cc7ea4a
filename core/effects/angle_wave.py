"""Errors of a joint that repeat with its angle. Compiled."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.effects.scene import Scene


def angle_wave(scene: Scene, order: Array, c: Array, s: Array) -> tuple[Array, Array]:
    """`c cos(order q) + s sin(order q)` per joint as the scene's windows show it, rad, and its second derivative, rad/s2.

    (N, n) each.

    Args:
        order: (n,), waves per turn.
        c, s: (n,), rad.
    """
    if scene.q is None or scene.dq is None:
        raise ValueError("errors of joints need a scene with joints (see Effect.explain_lack)")
    q, dq = scene.past("wave q").before(scene.q, 1), scene.past("wave dq").before(scene.dq, 1)
    error, acceleration = _wave(q, dq, *(np.ascontiguousarray(x) for x in (order, c, s)), scene.period, max(scene.window, scene.period))
    return error[-len(scene) :], acceleration[-len(scene) :]


@njit(cache=True)
def _wave(q: Array, dq: Array, order: Array, c: Array, s: Array, period: float, window: float) -> tuple[Array, Array]:
    N, n = q.shape
    error = np.zeros((N, n))
    acceleration = np.zeros((N, n))
    for j in range(n):
        if c[j] == 0.0 and s[j] == 0.0:
            continue
        for k in range(N):
            rate = order[j] * dq[k, j]
            growth = order[j] * (dq[k, j] - dq[max(k - 1, 0), j]) / period
            x = 0.5 * rate * window
            visible = (np.sin(x) / x) ** 4 if abs(x) > 1e-3 else 1.0  # what cubic B-splines leave of a sine
            cos, sin = visible * np.cos(order[j] * q[k, j]), visible * np.sin(order[j] * q[k, j])
            error[k, j] = c[j] * cos + s[j] * sin
            acceleration[k, j] = growth * (s[j] * cos - c[j] * sin) - rate * rate * error[k, j]
    return error, acceleration
