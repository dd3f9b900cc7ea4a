"""The reading grows faster, or slower, than the load."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.channels import full_scale, largest, shares, without_range
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene

Array = NDArray[np.float64]


class SensorNonlinearity(Effect):
    """`W = w + s w + e w |w| / FS`, FS the full scale of the channel (see `channels.full_scale`).

    The slope `s` says which straight line the sensor was adjusted to: the one through its reading at full load (`s = -e`), the best one
    over a part of its range, or, at zero, its tangent without load.
    """

    id = "sensor_nonlinearity"
    title = "a non-linearity of the sensor"
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return (
            *shares("full_scale_error_share", lower=-2.0, upper=2.0, scale=0.02),
            *shares("slope_error_share", lower=-0.5, upper=0.5, scale=0.02),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return np.asarray(w * (1.0 + theta[6:] + theta[:6] / full_scale(scene, w) * np.abs(w)))

    def tied_to_run(self, scene: Scene) -> str | None:
        """See `Effect.tied_to_run`."""
        return without_range(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """See `Effect.starts`."""
        return [np.zeros(12)]  # linear in its parameters: one step finds them

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        k, channel = largest(theta[:6])
        return f"Have the sensor's linearity checked with known weights: {channel} is bent by {100 * theta[k]:+.1f} % at full scale."
