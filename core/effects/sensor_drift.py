"""The offset changes with time or with temperature: a sensor that warms up."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import amplitudes, expand_to_channels, say_largest
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.effects.vectors import add_course
from core.words.message import Message

REFERENCE = 60.0
"""s after the start; the amplitudes are the drift at this time."""


class SensorDrift(Effect):
    """`W = w + A (1 - exp(-k t)) / (1 - exp(-k 60 s)) + B (T - T(0))`, the last term where the temperature is recorded.

    Zero at the start, `A` after one minute. `k` is one over the time constant: a ramp is `k = 0`, and a drift that grows faster and
    faster has `k < 0`.
    """

    id = "sensor_drift"
    title = Message.of("effect-sensor-drift-title")
    stage = "sensor"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Drift after one minute (6), N and N m, settling rate, 1/s, and where the temperature is recorded drift per K (6)."""
        time = (
            *amplitudes("first_minute", bound=expand_to_channels(50.0, 2.5), scale=expand_to_channels(1.0, 0.05)),
            Parameter("settling_rate_per_s", "1/s", 0.0, -0.02, 2.0, 0.03),
        )
        if scene.temperature is None:
            return time
        return (*time, *amplitudes("drift", bound=expand_to_channels(10.0, 0.5), scale=expand_to_channels(0.3, 0.015), per="K"))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the drift with time and, where it is recorded, with temperature; zero in the first row of the run."""
        W = add_course(w, settling(scene.elapsed, theta[6]), theta[:6])
        if scene.temperature is not None:
            first = scene.past("temperature").first(scene.temperature)
            W = add_course(W, scene.temperature - first, theta[7:])
        return np.asarray(W)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Drift with the signs by which the residual changes from its first to its last third, at rates of 0.01, 0.05 and 0.2 1/s."""
        third = max(1, len(residual) // 3)
        sign = np.sign(residual[-third:].mean(axis=0) - residual[:third].mean(axis=0))
        parameters = self.parameters(scene)
        start = np.zeros(len(parameters))
        start[:6] = 0.3 * sign * [p.scale for p in parameters[:6]]
        return [np.concatenate([start[:6], [k], start[7:]]) for k in (0.01, 0.05, 0.2)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises 20 min of warming up and taring before the run, with the drift over the run in N and N m."""
        seconds = float(scene.t[-1] - scene.t[0])
        return Message.of("advice-sensor-drift", drift=say_largest(self.find_drift(scene, theta)), within_s=seconds)

    def find_drift(self, scene: Scene, theta: Array) -> Array:
        """(6,), N and N m, from the first row to the last."""
        drift = theta[:6] * settling(np.array([float(scene.t[-1] - scene.t[0])]), theta[6])
        if scene.temperature is not None:
            drift = drift + theta[7:] * (scene.temperature[-1] - scene.temperature[0])
        return np.asarray(drift)


def settling(t: Array, k: float) -> Array:
    """`(1 - exp(-k t)) / (1 - exp(-k 60 s))`, (N,); `t / 60 s` at `k = 0`."""
    if abs(k) < 1e-8:
        return np.asarray(t / REFERENCE)
    return np.asarray(np.expm1(-k * t) / np.expm1(-k * REFERENCE))
