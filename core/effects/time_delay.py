"""The wrench is late against the joints: transport, buffering, or clocks that differ."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.excitation import stillness
from core.effects.filters import delay_signal
from core.effects.scene import Scene
from core.words.message import Message


class TimeDelay(Effect):
    """`W(t - tau)`, between samples by a quintic. A wrench that is early means joints that are late, which is `kinematic_lag`."""

    id = "time_delay"
    title = Message.of("effect-time-delay-title")
    stage = "timing"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The delay, s."""
        return (Parameter("delay_s", "s", 0.0, 0.0, 0.2, 0.02),)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w(t - tau)`, by a quintic between samples."""
        return delay_signal(w, theta[0] / scene.period, scene.past("wrench"))

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where the sensor stays still: a delay shows only while loads change."""
        return stillness(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Delays of 6, 20 and 50 ms."""
        return [np.array([delay]) for delay in (0.006, 0.02, 0.05)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises one clock for wrench and joints, or the delay in the recorder, ms."""
        return Message.of("advice-time-delay", delay_s=theta[0])
