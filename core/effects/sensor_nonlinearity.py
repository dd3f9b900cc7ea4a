"""The reading grows faster, or slower, than the load."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.channels import full_scale, largest, shares, without_range
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene

Array = NDArray[np.float64]


class SensorNonlinearity(Effect):
    """`W = w + e w |w| / FS`, FS the full scale of the channel (see `channels.full_scale`)."""

    id = "sensor_nonlinearity"
    title = "a non-linearity of the sensor"
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return shares("full_scale_error_share", lower=-1.0, upper=1.0, scale=0.02)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return np.asarray(w + theta / full_scale(scene, w) * w * np.abs(w))

    def tied_to_run(self, scene: Scene) -> str | None:
        """See `Effect.tied_to_run`."""
        return without_range(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """See `Effect.starts`."""
        return [np.zeros(6)]  # linear in its parameters: one step finds them

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        k, channel = largest(theta)
        return f"Have the sensor's linearity checked with several known weights: {channel} is off by {100 * theta[k]:+.1f} % at full scale."
