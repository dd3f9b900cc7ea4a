"""The offset jumps once: a knock, an overload, a re-tare during the run."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.change_points import change_points
from core.effects.channels import amplitudes, expand_to_channels, say_largest
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.effects.vectors import add_course
from core.words.message import Message


class SensorOffsetStep(Effect):
    """`W = w + A` from `t0` on, reached within one sample after it so that `t0` can be fitted between samples."""

    id = "sensor_offset_step"
    title = Message.of("effect-sensor-offset-step-title")
    stage = "sensor"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Jump of each channel, N and N m, and its time, s, from the first sample on."""
        seconds = float(scene.t[-1] - scene.t[0])
        time = Parameter("step_time_s", "s", seconds / 2, 0.0, seconds, max(seconds, scene.period))
        return (*amplitudes("step", bound=expand_to_channels(100.0, 10.0), scale=expand_to_channels(1.5, 0.08)), time)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the jump A from t0 on, reached within one sample."""
        step = np.clip((scene.elapsed - theta[6]) / scene.period, 0.0, 1.0)
        return np.asarray(add_course(w, step, theta[:6]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The jumps, at most four, that the residual shows, with the signs that it shows there; the default where it shows none."""
        beside = max(2, round(0.5 / scene.period))
        scale = np.array([p.scale for p in self.parameters(scene)[:6]])
        starts = []
        for row in change_points(residual, count=4, apart=beside):
            jump = residual[row : row + beside].mean(axis=0) - residual[row - beside : row].mean(axis=0)
            starts.append(np.append(0.3 * scale * np.sign(jump), (row - 0.5) * scene.period))
        return starts or super().starts(scene, residual)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises checking plug and cable and taring, with the time, s, and the jump, N and N m."""
        return Message.of("advice-sensor-offset-step", at_s=theta[6], step=say_largest(theta[:6]))
