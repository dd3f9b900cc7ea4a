"""From a certain load on the reading grows at another slope: something gets into contact inside the sensor."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, find_load_at_rest, say_load, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_nonlinearity import SensorNonlinearity
from core.words.message import Message

KNEES = (0.25, 0.5, 0.75)
"""To start from."""


class NonlinearityWithKnee(SensorNonlinearity):
    """`W = w + s w + b (w - clip(w, -k L, k L))`, L the most that the payload makes of a channel at rest."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six changes `b` of the slope, as shares, the knee `k`, a share of the load, then six errors `s` of the slope, as shares."""
        return (
            *shares("slope_change_share", lower=-0.5, upper=0.5, scale=0.02),
            Parameter("knee_share", "1", 0.5, 0.02, 1.0, 0.2),
            *shares("slope_error_share", lower=-0.5, upper=0.5, scale=0.02),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """Right below the knee."""
        return 7

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + s w + b (w - clip(w, -k L, k L))` in each channel."""
        knee = theta[6] * find_load_at_rest(scene.phi)
        return np.asarray(w * (1.0 + theta[7:]) + theta[:6] * (w - np.clip(w, -knee, knee)))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Knees at some loads, with the signs by which the residual goes with what is beyond."""
        load = find_load_at_rest(scene.phi)
        beyond = [scene.nominal - np.clip(scene.nominal, -k * load, k * load) for k in KNEES]
        signs = [np.sign((residual * x).sum(axis=0)) for x in beyond]
        return [np.concatenate((0.01 * sign, [k], np.zeros(6))) for k, sign in zip(KNEES, signs, strict=True)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises looking for what touches, with the largest change of a slope in %, and the load from which on it is there."""
        k, channel = find_largest_channel(theta[:6])
        load = theta[6] * find_load_at_rest(scene.phi)[k]
        return Message.of("advice-sensor-nonlinearity-knee", channel=channel, change_share=theta[k], load=say_load(float(load), k))
