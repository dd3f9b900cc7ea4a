"""The gain changes while the sensor warms up: a supply that sags, a spring that softens; the offset may go along."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import amplitudes, expand_to_channels, find_largest_channel, shares
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_drift import settling
from core.effects.sensor_gain import SensorGain
from core.words.message import Message

RATES = (0.01, 0.05, 0.2)
"""To start from, 1/s."""


class GainThatWarmsUp(SensorGain):
    """`W = w + (g w + A) (1 - exp(-k t)) / (1 - exp(-k 60 s))`: right at the start, gains and offsets then settle with one rate.

    A ramp is `k = 0`. The payload takes up a gain that all channels have from the start.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Change of each gain after one minute (6), as a share, settling rate, 1/s, and that of each offset (6), N and N m."""
        return (
            *shares("gain_change_share", lower=-0.5, upper=0.5, scale=0.03),
            Parameter("settling_rate_per_s", "1/s", 0.0, -0.02, 2.0, 0.03),
            *amplitudes("first_minute", bound=expand_to_channels(50.0, 2.5), scale=expand_to_channels(1.0, 0.05)),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """Gains alone."""
        return 7

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what gains and offsets have changed by then."""
        return np.asarray(w + settling(scene.elapsed, theta[6])[:, None] * (theta[:6] * w + theta[7:]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Gains with the signs by which the residual goes with the load more and more, at some rates."""
        late = scene.elapsed - scene.elapsed.mean()
        sign = np.sign((residual * scene.nominal * late[:, None]).sum(axis=0))
        return [np.concatenate((0.01 * sign, [k], np.zeros(6))) for k in RATES]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises warming up before the run, with the largest change of a gain over the run in %."""
        seconds = float(scene.t[-1] - scene.t[0])
        change = theta[:6] * settling(np.array([seconds]), theta[6])
        k, channel = find_largest_channel(change)
        return Message.of("advice-sensor-gain-warming", channel=channel, change_share=change[k], within_s=seconds)
