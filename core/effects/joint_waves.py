"""Waves along the angle of each joint of a run, compiled; those that were asked for last are kept for all that is fitted to the run."""

from __future__ import annotations

from collections import OrderedDict

import numpy as np
from numba import njit

from core.array import Array


class JointWaves:
    """The waves of each joint along one run that were asked for last. Nothing of it goes to another process."""

    MOST = 40
    """Kept: those of seven joints with what a few derivatives make of one."""

    def __init__(self) -> None:
        self._known: OrderedDict[tuple[int, bytes], Array] = OrderedDict()

    def find(self, q: Array, dq: Array, joint: int, waves: Array, period: float, window: float) -> Array:
        """(2, N), error, rad, and its second derivative, rad/s2, of waves (m, 3) with order, c and s."""
        key = (joint, waves.tobytes())
        if key not in self._known:
            self._known[key] = _add_waves(np.ascontiguousarray(q[:, joint]), np.ascontiguousarray(dq[:, joint]), waves, period, window)
            if len(self._known) > self.MOST:
                self._known.popitem(last=False)
        self._known.move_to_end(key)
        return self._known[key]

    def __reduce__(self) -> tuple[type[JointWaves], tuple[()]]:
        return JointWaves, ()


@njit(cache=True)
def _add_waves(q: Array, dq: Array, waves: Array, period: float, window: float) -> Array:
    out = np.zeros((2, len(q)))
    for order, c, s in waves:
        if c == 0.0 and s == 0.0:
            continue
        for k in range(len(q)):
            rate = order * dq[k]
            growth = order * (dq[k] - dq[max(k - 1, 0)]) / period
            x = 0.5 * rate * window
            visible = (np.sin(x) / x) ** 4 if abs(x) > 1e-3 else 1.0  # what cubic B-splines leave of a sine
            cos, sin = visible * np.cos(order * q[k]), visible * np.sin(order * q[k])
            error = c * cos + s * sin
            out[0, k] += error
            out[1, k] += growth * (s * cos - c * sin) - rate * rate * error
    return out
