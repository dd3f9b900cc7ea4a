"""The offset jumps and comes back in part: an overload whose strain relaxes."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_offset_step import SensorOffsetStep
from core.words.message import Message

RECOVERIES_S, KEPT = (1.0, 5.0), 0.7
"""Time constants, and the share that stays, to start from."""


class OffsetStepThatRecovers(SensorOffsetStep):
    """`W = w + A (r + (1 - r) exp(-(t - t0) / T))` from t0 on: a share r of the jump stays."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the jump, then the share that stays, and the time constant T, s."""
        return (
            *super().parameters(scene),
            Parameter("kept_share", "1", 1.0, -0.5, 1.5, 0.3),
            Parameter("recovery_s", "s", 3.0, 0.1, 60.0, 3.0),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what the jump is by then."""
        jump = super().wrench(scene, np.zeros_like(w), theta[:7])
        kept, recovery = theta[7:]
        since = np.maximum(scene.elapsed - theta[6], 0.0)
        return np.asarray(w + (kept + (1.0 - kept) * np.exp(-since / recovery))[:, None] * jump)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The most probable jump, larger at first, with quick and slow recovery."""
        return self.starts_beside(scene, residual, super().starts(scene, residual)[0][:7])

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The jump that stays, larger at first, with quick and slow recovery."""
        return [np.concatenate((plain[:6] / KEPT, plain[6:], [KEPT, recovery])) for recovery in RECOVERIES_S]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of a jump that stays."""
        return super().advice(scene, theta[:7])
