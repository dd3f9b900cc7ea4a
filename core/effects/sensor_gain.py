"""The scale of a channel is off: calibration, or an amplifier that has been exchanged."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.channels import largest, shares
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene

Array = NDArray[np.float64]


class SensorGain(Effect):
    """`W = diag(1 + e) w`."""

    id = "sensor_gain"
    title = "a gain error of the sensor's channels"
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return shares("gain_error_share", lower=-0.5, upper=0.5, scale=0.03)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return np.asarray(w * (1.0 + theta))

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        k, channel = largest(theta)
        return f"Have the sensor recalibrated with known weights: {channel} reads {100 * theta[k]:+.1f} % against the other channels."
