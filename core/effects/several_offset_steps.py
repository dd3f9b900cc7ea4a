"""The offset jumps several times: a plug that is loose, a cable that is pulled again and again."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import SUFFIXES
from core.effects.effect import Parameter
from core.effects.jump_search import find_jumps
from core.effects.scene import Scene
from core.effects.sensor_offset_step import SensorOffsetStep
from core.payload.channels import CHANNELS

JUMPS = 4


class SeveralOffsetSteps(SensorOffsetStep):
    """`W = w + A_k` from `t_k` on, four times; with the parameters of each as `SensorOffsetStep` has them of one."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of one jump for each, the first one's by their own names."""
        one = super().parameters(scene)
        names = [*(f"{channel}_{suffix}" for channel, suffix in zip(CHANNELS, SUFFIXES, strict=True)), "at_s"]
        later = (
            Parameter(f"jump_{k}_{name}", p.unit, p.absent, p.lower, p.upper, p.scale)
            for k in range(2, JUMPS + 1)
            for name, p in zip(names, one, strict=True)
        )
        return (*one, *later)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus all jumps."""
        for one in theta.reshape(JUMPS, 7):
            w = super().wrench(scene, w, one)
        return w

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The jumps that together explain most of the residual, with the signs that they have there."""
        found = find_jumps(scene, residual, np.eye(6), JUMPS)
        if found is None:
            return [np.array([p.absent for p in self.parameters(scene)])]
        times, sizes = found
        scale = np.array([p.scale for p in super().parameters(scene)[:6]])
        return [np.column_stack((0.3 * scale * np.sign(sizes), times)).ravel()]
