"""A filter that opens while its input runs away from its output, as in weighing amplifiers: calm at rest, quick in a change."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from core.array import Array
from core.effects.channels import find_load_at_rest, shares
from core.effects.effect import Parameter
from core.effects.memory import Past
from core.effects.scene import Scene
from core.effects.sensor_lowpass import SensorLowpass
from core.words.message import Message

OPENINGS = (5.0, 20.0)
"""From which fits start."""


class LowpassThatOpens(SensorLowpass):
    """`tau dy/dt = (1 + a |w - y| / L) (w - y)` in each channel, L the most that the payload makes of it at rest."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Time constant tau, s, and for each channel by how much it opens, `a`."""
        return (Parameter("time_constant_s", "s", 0.0, 0.0, 0.3, 0.03), *shares("opening_factor", lower=0.0, upper=100.0, scale=10.0))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """The output `y` behind each channel of `w`."""
        opening = theta[1:] / find_load_at_rest(scene.phi)
        return _follow(np.ascontiguousarray(w), float(theta[0]), opening, scene.period, scene.past("opening pole"))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where a plain filter leaves something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """A filter slower than the plain one, which opens."""
        return [np.array([min(2.0 * float(plain[0]), 0.3), *[opening] * 6]) for opening in OPENINGS]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of the plain one, at rest."""
        return Message.of("advice-sensor-lowpass", cutoff_hz=1 / (2 * math.pi * max(float(theta[0]), 1e-6)), delay_s=theta[0])


def _follow(w: Array, time_constant: float, opening: Array, period: float, past: Past) -> Array:
    if time_constant < 1e-9 * period:
        return w.copy()
    before, y = (w[0], w[0]) if past.rows is None else (past.rows[0], past.rows[1])
    out = np.asarray(_outputs(w, before, y, period / time_constant, opening))
    past.rows = np.stack([w[-1], out[-1]])
    return out


@njit(cache=True)
def _outputs(w: Array, before: Array, y: Array, rate: float, opening: Array) -> Array:
    """Behind inputs that stay at their mean from row to row, after the input and the output of the row before the first."""
    N, n = w.shape
    out = np.empty_like(w)
    for j in range(n):
        last, now = before[j], y[j]
        for k in range(N):
            away = 0.5 * (last + w[k, j]) - now
            now -= math.expm1(-rate * (1.0 + abs(away) * opening[j])) * away
            out[k, j], last = now, w[k, j]
    return out
