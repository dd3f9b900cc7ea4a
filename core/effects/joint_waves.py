"""Waves along the angle of each joint of a run, compiled; those that were asked for last are kept for all that is fitted to the run, and so
are their cosines and sines, which are the same for waves of any size."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from functools import partial

import numpy as np
from numba import njit

from core.array import Array


class JointWaves:
    """The waves of each joint along one run that were asked for last. Nothing of it goes to another process."""

    MOST = 40
    """Kept: those of seven joints with what a few derivatives make of one,"""
    MOST_PAIRS = 90
    """and of six waves of each their cosine and sine, as often again for derivatives by their orders."""

    def __init__(self) -> None:
        self._waves, self._pairs = _Latest(self.MOST), _Latest(self.MOST_PAIRS)

    def find(self, q: Array, dq: Array, joint: int, waves: Array, period: float, window: float) -> Array:
        """(2, N), error, rad, and its second derivative, rad/s2, of waves (m, 3) with order, c and s."""
        return self._waves.find((joint, waves.tobytes()), partial(self._add, q, dq, joint, waves, period, window))

    def _add(self, q: Array, dq: Array, joint: int, waves: Array, period: float, window: float) -> Array:
        angle, rate, out = np.ascontiguousarray(q[:, joint]), np.ascontiguousarray(dq[:, joint]), np.zeros((2, len(q)))
        for order, c, s in waves[waves[:, 1:].any(axis=1)]:
            pair = self._pairs.find((joint, order), partial(_make_pair, angle, rate, order, window))
            _add_wave(pair, rate, order, c, s, period, out)
        return out

    def __reduce__(self) -> tuple[type[JointWaves], tuple[()]]:
        return JointWaves, ()


class _Latest:
    """Arrays, of which those that nobody has asked for lately give way."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._known: OrderedDict[Hashable, Array] = OrderedDict()

    def find(self, key: Hashable, make: Callable[[], Array]) -> Array:
        if key not in self._known:
            self._known[key] = make()
            if len(self._known) > self._most:
                self._known.popitem(last=False)
        self._known.move_to_end(key)
        return self._known[key]


@njit(cache=True)
def _make_pair(angle: Array, rate: Array, order: float, window: float) -> Array:
    """(2, N), cosine and sine of the order as windows show them."""
    out = np.empty((2, len(angle)))
    for k in range(len(angle)):
        x = 0.5 * (order * rate[k]) * window
        visible = (np.sin(x) / x) ** 4 if abs(x) > 1e-3 else 1.0  # what cubic B-splines leave of a sine
        out[0, k], out[1, k] = visible * np.cos(order * angle[k]), visible * np.sin(order * angle[k])
    return out


@njit(cache=True)
def _add_wave(pair: Array, rate: Array, order: float, c: float, s: float, period: float, out: Array) -> None:
    for k in range(len(rate)):
        turning = order * rate[k]
        growth = order * (rate[k] - rate[max(k - 1, 0)]) / period
        error = c * pair[0, k] + s * pair[1, k]
        out[0, k] += error
        out[1, k] += growth * (s * pair[0, k] - c * pair[1, k]) - turning * turning * error
