"""The offset jumps several times by shares of the same wrench: a clamp that settles in clicks, a plug that is loose."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.jump_search import find_jumps
from core.effects.scene import Scene
from core.effects.sensor_offset_step import SensorOffsetStep
from core.words.message import Message

JUMPS = 4


class OffsetThatClicks(SensorOffsetStep):
    """`W = w + A (1(t > t_1) + sum of s_k 1(t > t_k))`: what gives way once does so again, so the others are shares s_k of the first."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the first jump, then share and time, s, of each other one."""
        one = super().parameters(scene)
        at = one[6]
        later = (
            (
                Parameter(f"jump_{k}_of_first_share", "1", 0.0, -3.0, 3.0, 0.5),
                Parameter(f"jump_{k}_at_s", "s", at.absent, at.lower, at.upper, at.scale),
            )
            for k in range(2, JUMPS + 1)
        )
        return (*one, *(parameter for pair in later for parameter in pair))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus all jumps."""
        first, later = theta[:7], theta[7:].reshape(JUMPS - 1, 2)
        w = super().wrench(scene, w, first)
        for share, at in later:
            w = super().wrench(scene, w, np.append(share * first[:6], at))
        return w

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The jumps that together explain most of the residual, all along the one that explains most by itself; the largest first."""
        one = find_jumps(scene, residual, np.eye(6), 1)
        several = None if one is None else find_jumps(scene, residual, one[1].T, JUMPS)
        if one is None or several is None:
            return []
        times, sizes = several[0], several[1][:, 0]
        order = np.argsort(-np.abs(sizes))
        shares = sizes[order] / sizes[order[0]]
        scale = np.array([p.scale for p in super().parameters(scene)[:6]])
        first = 0.3 * scale * np.sign(one[1][0] * sizes[order[0]])
        return [np.concatenate((first, times[order[:1]], np.column_stack((shares, times[order]))[1:].ravel()))]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of the first jump."""
        return super().advice(scene, theta[:7])
