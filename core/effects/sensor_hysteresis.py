"""The reading depends on the direction from which a load was approached."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from core.effects.channels import full_scale, largest, shares
from core.effects.effect import Effect, Parameter
from core.effects.filters import play
from core.effects.scene import Scene

Array = NDArray[np.float64]


class SensorHysteresis(Effect):
    """`W = w - exp(-s) (w - play_R(w))` with `R = h FS exp(s)`.

    The reading is at most `h FS` behind the load: half the height of the loop. At `s = 0` this is the play operator; with `s > 0` the
    loop turns more gently, over a change of load `exp(s)` times as long, as sensors (and the Bouc-Wen model) do. Starts without
    hysteresis; the constant offset stands for what happened before. Source: Visintin, Differential Models of Hysteresis (1994), ch. III
    (play and stop).
    """

    id = "sensor_hysteresis"
    title = "hysteresis of the sensor"
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return (
            *shares("half_width_share", lower=0.0, upper=0.1, scale=0.003),
            Parameter("turning_log_ratio", "1", 0.0, 0.0, 5.0, 2.0),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        stretch = math.exp(theta[6])
        return np.asarray(w - (w - play(w, theta[:6] * full_scale(scene, w) * stretch)) / stretch)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """See `Effect.starts`."""
        return [np.append(np.full(6, width), s) for width, s in ((0.001, 0.5), (0.001, 2.0), (0.004, 1.0))]

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        k, channel = largest(theta[:6])
        return (
            f"Check the bolts of the sensor's flanges for slip, else approach every pose from the same side: "
            f"{channel} differs by {200 * theta[k]:.2f} % of full scale between loading and unloading."
        )
