"""The reading grows faster, or slower, than the load."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, full_scale, shares, without_range
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.words.message import Message


class SensorNonlinearity(Effect):
    """`W = w + s w + e w |w| / FS`, FS the full scale of the channel (see `channels.full_scale`).

    The slope `s` says which straight line the sensor was adjusted to: the one through its reading at full load (`s = -e`), the best one
    over a part of its range, or, at zero, its tangent without load.
    """

    id = "sensor_nonlinearity"
    title = Message.of("effect-sensor-nonlinearity-title")
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six bends `e` at full scale, then six errors `s` of the slope, all as shares."""
        return (
            *shares("full_scale_error_share", lower=-2.0, upper=2.0, scale=0.02),
            *shares("slope_error_share", lower=-0.5, upper=0.5, scale=0.02),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """The bends without an error of the slope."""
        return 6

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + s w + e w |w| / FS` in each channel."""
        return np.asarray(w * (1.0 + theta[6:] + theta[:6] / full_scale(scene, w) * np.abs(w)))

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """A reason where the sensor's range is not known: shares of it then hold for this run only."""
        return super().explain_tie_to_run(scene) or without_range(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """All zero."""
        return [np.zeros(12)]  # linear in its parameters: one step finds them

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises checking the linearity with known weights, with the largest bend in % at full scale."""
        k, channel = find_largest_channel(theta[:6])
        return Message.of("advice-sensor-nonlinearity", channel=channel, bend_share=theta[k])
