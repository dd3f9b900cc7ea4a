"""The recorded motion is late: velocity observers and encoder filters in the robot's controller."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.effects.excitation import stillness
from core.effects.filters import derivative
from core.effects.scene import Scene

Array = NDArray[np.float64]


class KinematicLag(Effect):
    """`W = w + tau dw/dt`: the wrench of the true motion, which is ahead of the recorded one.

    Recorded joints are `q_rec = q / (1 + tau s)`, so the true ones are `q = q_rec + tau dq_rec/dt`, and the wrench is a function of the
    motion, `w(q + tau dq) = w + tau dw/dt + O(tau^2)`. The remainder is quadratic in velocities times `tau` (1e-3 of the wrench at 1
    rad/s and 30 ms).
    """

    id = "kinematic_lag"
    title = "a lag of the recorded motion"
    stage = "timing"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        return (Parameter("lag_s", "s", 0.0, 0.0, 0.1, 0.015),)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        return np.asarray(w + theta[0] * derivative(w, scene.period, scene.past("wrench")))

    def missing(self, scene: Scene) -> str | None:
        """See `Effect.missing`."""
        return stillness(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """See `Effect.starts`."""
        return [np.array([lag]) for lag in (0.01, 0.03)]

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        return f"Record unfiltered joint positions, or shift the joints' time stamps {1e3 * theta[0]:.1f} ms earlier."
