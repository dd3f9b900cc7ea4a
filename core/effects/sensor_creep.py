"""The reading creeps after a change of load: glue and strain gauges relax."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import find_largest_channel, shares
from core.effects.effect import Effect, Parameter
from core.effects.filters import low_pass
from core.effects.scene import Scene
from core.words.message import Message


class SensorCreep(Effect):
    """`W = w + K w / (1 + tau s)`: every step of load is followed by `K (1 - exp(-t / tau))` of it. At the start all creep is over."""

    id = "sensor_creep"
    title = Message.of("effect-sensor-creep-title")
    stage = "sensor"
    needs_motion = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six shares of the load that creep, and one time constant, s."""
        return (*shares("creep_share", lower=-0.2, upper=0.2, scale=0.005), Parameter("time_constant_s", "s", 30.0, 0.3, 1000.0, 40.0))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + K w / (1 + tau s)` in each channel, all creep over in the first row of the run."""
        return np.asarray(w + theta[:6] * low_pass(w, theta[6], scene.period, scene.past("creep")))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Creep of 0.2 % in all channels with time constants of 10, 2 and 60 s."""
        return [np.append(np.full(6, 0.002), tau) for tau in (10.0, 2.0, 60.0)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises waiting for three time constants, s, after a change of load; the largest creep in %."""
        k, channel = find_largest_channel(theta[:6])
        return Message.of("advice-sensor-creep", wait_s=3 * theta[6], channel=channel, creep_share=theta[k], within_s=theta[6])
