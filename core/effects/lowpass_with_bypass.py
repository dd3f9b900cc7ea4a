"""A filter that a part of the signal goes round: a capacitor with a series resistance, a lead beside a lag."""

from __future__ import annotations

import math

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import low_pass
from core.effects.scene import Scene
from core.effects.sensor_lowpass import SensorLowpass
from core.words.message import Message

SHARES = (0.2, 0.5)
"""From which fits start; the slower the filter, the more may go round it."""


class LowpassWithBypass(SensorLowpass):
    """`W = w (1 + d tau s) / (1 + tau s)`: a share d of every change comes at once."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Time constant tau, s, and the share d."""
        return (Parameter("time_constant_s", "s", 0.0, 0.0, 0.3, 0.03), Parameter("direct_share", "1", 0.0, 0.0, 0.95, 0.3))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`d w + (1 - d) w / (1 + tau s)`."""
        tau, direct = theta
        return np.asarray(direct * w + (1.0 - direct) * low_pass(w, float(tau), scene.period, scene.past("pole")))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where a plain filter leaves something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """A filter that is as late as the plain one, `tau (1 - d)`, with either share."""
        return [np.array([min(float(plain[0]) / (1.0 - share), 0.3), share]) for share in SHARES]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of the plain one: slow signals are late by `tau (1 - d)`."""
        tau, direct = theta.tolist()
        return Message.of("advice-sensor-lowpass", cutoff_hz=1 / (2 * math.pi * max(tau, 1e-6)), delay_s=tau * (1.0 - direct))
