"""The scale of a channel is off: calibration, or an amplifier that has been exchanged."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, shares
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.words.message import Message


class SensorGain(Effect):
    """`W = w + e w + a |w|`: a channel is off by `e + a` where it is pulled and by `e - a` where it is pushed."""

    id = "sensor_gain"
    title = Message.of("effect-sensor-gain-title")
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six gain errors, then six asymmetries between pull and push, all as shares."""
        return (
            *shares("gain_error_share", lower=-0.5, upper=0.5, scale=0.03),
            *shares("asymmetry_share", lower=-0.25, upper=0.25, scale=0.01),
        )

    def smaller_shape(self, scene: Scene) -> int | None:
        """The gain errors without asymmetry."""
        return 6

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + e w + a |w|` in each channel."""
        return np.asarray(w * (1.0 + theta[:6]) + np.abs(w) * theta[6:])

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """All zero."""
        return [np.zeros(12)]  # linear in its parameters: one step finds them

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises recalibration in both directions, with the errors of the worst channel for positive and negative loads in %."""
        pulled, pushed = theta[:6] + theta[6:], theta[:6] - theta[6:]
        k, channel = find_largest_channel(np.abs(pulled) + np.abs(pushed))
        return Message.of("advice-sensor-gain", channel=channel, positive_share=pulled[k], negative_share=pushed[k])
