"""The offset jumps several times: a plug that is loose, a cable that is pulled again and again."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from core.array import Array
from core.effects.change_points import change_points
from core.effects.channels import SUFFIXES
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_offset_step import SensorOffsetStep
from core.payload.channels import CHANNELS
from core.words.message import Message

JUMPS, CANDIDATES = 4, 12
APART_S = 0.5


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

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """They happened once, at their times."""
        return Message.of("effect-shape-of-run")

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The jumps that the residual shows: of the rows where its mean may change, those that leave least within the stretches between."""
        apart = max(2, round(APART_S / scene.period))
        candidates, rows = change_points(residual, count=CANDIDATES, apart=apart), [0, len(residual)]
        if len(candidates) < JUMPS:
            return [np.array([p.absent for p in self.parameters(scene)])]
        for _ in range(JUMPS):
            rows = min((sorted((*rows, row)) for row in candidates if row not in rows), key=lambda edges: _find_spread(residual, edges))
        means = np.array([residual[a:b].mean(axis=0) for a, b in pairwise(rows)])
        scale = np.array([p.scale for p in super().parameters(scene)[:6]])
        times = (np.array(rows[1:-1]) - 0.5) * scene.period
        return [np.column_stack((0.3 * scale * np.sign(np.diff(means, axis=0)), times)).ravel()]


def _find_spread(x: Array, edges: list[int]) -> float:
    """Sum of squares of rows (N, n) about the means of the stretches between the edges."""
    return sum(float(np.square(x[a:b] - x[a:b].mean(axis=0)).sum()) for a, b in pairwise(edges))
