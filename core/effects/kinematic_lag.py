"""The recorded motion is late: velocity observers and encoder filters in the robot's controller."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.excitation import stillness
from core.effects.filters import derivative
from core.effects.scene import Scene
from core.words.message import Message


class KinematicLag(Effect):
    """`W = w + tau dw/dt`: the wrench of the true motion, which is ahead of the recorded one.

    Recorded joints are `q_rec = q / (1 + tau s)`, so the true ones are `q = q_rec + tau dq_rec/dt`, and the wrench is a function of the
    motion, `w(q + tau dq) = w + tau dw/dt + O(tau^2)`. The remainder is quadratic in velocities times `tau` (1e-3 of the wrench at 1
    rad/s and 30 ms).
    """

    id = "kinematic_lag"
    title = Message.of("effect-kinematic-lag-title")
    stage = "timing"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The lag, s."""
        return (Parameter("lag_s", "s", 0.0, 0.0, 0.1, 0.015),)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + tau dw/dt`, the derivative from each row and the three before it."""
        return np.asarray(w + theta[0] * derivative(w, scene.period, scene.past("wrench")))

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where the sensor stays still: a lag shows only while loads change."""
        return stillness(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Lags of 10 and 30 ms."""
        return [np.array([lag]) for lag in (0.01, 0.03)]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises unfiltered joint positions, or time stamps that are earlier by the lag, ms."""
        return Message.of("advice-kinematic-lag", lag_s=theta[0])
