"""What of a joint's torque no model explains: white noise, and a part that lasts a while.

Friction is never quite the function of velocity and load that it is fitted by, and what is left comes and goes with the motion. It is
taken as an Ornstein-Uhlenbeck process beside the white noise of the windows. Size and duration are found for each joint by the
restricted likelihood, so that a second of one joint counts as few independent samples as it holds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit

from core.array import Array

SHORTEST_S, USUAL_S, LONGEST_S = 0.1, 1.0, 5.0
"""Correlation times that are considered; about the usual one with a factor e of prior spread."""
LEAST_WHITE = 0.5
"""Of what lasts: without it only differences from window to window would count, which gears, filters and delays spoil first."""


@dataclass(frozen=True)
class TorqueNoise:
    """Of one joint.

    Args:
        white: standard deviation of one window, N m.
        lasting: standard deviation of what lasts, N m; `time_s`: for how long.
    """

    white: float
    lasting: float
    time_s: float

    @classmethod
    def of_logarithms(cls, x: Array) -> TorqueNoise:
        """From the logarithms (3,) that are searched over."""
        white, lasting, time_s = np.exp(np.clip(x, -40.0, 40.0)).tolist()
        return cls(white, lasting, float(np.clip(time_s, SHORTEST_S, LONGEST_S)))

    def to_logarithms(self, white: float) -> Array:
        """(3,), logarithms whose noise `with_floor(white)` is this one."""
        square = self.white**2 - white**2 - (LEAST_WHITE * self.lasting) ** 2
        return np.log([np.sqrt(max(square, 0.01 * self.white**2)), max(self.lasting, 0.01 * self.white), self.time_s])

    def with_floor(self, white: float) -> TorqueNoise:
        """With so much more white noise, N m, that nothing is ever exact, and a share of what lasts."""
        return TorqueNoise(float(np.sqrt(self.white**2 + white**2 + (LEAST_WHITE * self.lasting) ** 2)), self.lasting, self.time_s)

    @property
    def std(self) -> float:
        """Of one window, all together, N m."""
        return float(np.hypot(self.white, self.lasting))

    @property
    def penalty(self) -> float:
        """Minus the logarithm of the prior of the correlation time."""
        return 0.5 * float(np.log(self.time_s / USUAL_S)) ** 2


def whiten_torques(columns: Array, t: Array, noise: TorqueNoise) -> tuple[Array, float]:
    """Columns (K, m) at increasing times t (K,), s, as innovations of unit variance, and half the log-determinant of their covariance.

    A step back in time begins a new series.
    """
    white, half = _whiten(np.ascontiguousarray(columns), t, noise.white**2, noise.lasting**2, noise.time_s)
    return np.asarray(white), float(half)


@njit(cache=True)
def _whiten(columns: Array, t: Array, white: float, lasting: float, time_s: float) -> tuple[Array, float]:
    """Kalman's filter of one state over every column at once."""
    count, m = columns.shape
    out = np.empty((count, m))
    state = np.zeros(m)
    variance = lasting
    half = 0.0
    for k in range(count):
        if k > 0:
            step = t[k] - t[k - 1]
            keep = np.exp(-step / time_s) if step > 0.0 else 0.0
            variance = keep * keep * variance + (1.0 - keep * keep) * lasting
            for c in range(m):
                state[c] *= keep
        total = variance + white
        half += 0.5 * np.log(total)
        gain, scale = variance / total, 1.0 / np.sqrt(total)
        for c in range(m):
            innovation = columns[k, c] - state[c]
            out[k, c] = innovation * scale
            state[c] += gain * innovation
        variance -= gain * variance
    return out, half
