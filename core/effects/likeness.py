"""How much a trial change of the wrench looks like what a twin leaves over: at which of many starting values a fit is worth beginning."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from operator import itemgetter
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.effect import Effect
from core.effects.scene import Scene
from core.effects.window_search import columns_of_payload_and_offsets, weights

AXES = np.array([axis for axis in np.ndindex(3, 3, 3) if axis > (1, 1, 1)], dtype=float) - 1.0
"""(13, 3), edges and diagonals of a cube, of length 1: the axes that are looked at before a fit."""
AXES /= np.linalg.norm(AXES, axis=1)[:, None]
ROUNDS = 8
"""In which each parameter is moved, at most,"""
LOOKED_AT = 600
"""No more rows than about this many are looked at."""
HALVED = 0.5
"""by steps that become so much shorter where none of them is any good."""


def find_most_alike(effect: Effect, scene: Scene, residual: Array, thetas: Iterable[Array], steps: Array, most: int) -> list[Array]:
    """The parameters of an effect that only adds, best first, whose change of the wrench, made larger or smaller, takes most out of the
    residual beyond what payload and offsets take up, each moved to where it takes more; none that takes nothing.

    Args:
        residual: (N, 6), measured minus predicted, in standard deviations of the noise.
        steps: by which each parameter is moved at first; 0 where it stays.
        most: of them.
    """
    likeness = _Likeness.of(effect, scene, residual)
    found = sorted(((likeness(theta), theta) for theta in thetas), key=itemgetter(0), reverse=True)[:most]
    moved = [_climb(likeness, gain, theta, steps) for gain, theta in found if gain > 0.0]
    return [theta for _, theta in sorted(moved, key=itemgetter(0), reverse=True)]


class _Likeness(NamedTuple):
    """What the effect takes out of the residual's square; both are free of what payload and offsets, the columns Q, take up.

    Args:
        scene: of few rows.
        wanted: (6 n,), the residual in them.
        scale: (6,), by which wrenches are weighed as it is.
    """

    effect: Effect
    scene: Scene
    wanted: Array
    Q: Array
    scale: Array

    @classmethod
    def of(cls, effect: Effect, scene: Scene, residual: Array) -> _Likeness:
        rows = slice(0, None, max(1, len(scene) // LOOKED_AT))
        wanted = residual[rows].ravel()
        Q = np.linalg.qr(columns_of_payload_and_offsets(scene, rows).reshape(wanted.size, -1))[0]
        few = replace(scene[rows], step=scene.period * rows.step)
        return cls(effect, few, wanted - Q @ (Q.T @ wanted), Q, weights(scene))

    def __call__(self, theta: Array) -> float:
        added = (self.effect.wrench(self.scene, np.zeros((len(self.scene), 6)), theta) * self.scale).ravel()
        taken, along = self.Q.T @ added, float(added @ self.wanted)
        return along * abs(along) / max(float(added @ added - taken @ taken), 1e-12)


def _climb(likeness: _Likeness, gain: float, theta: Array, steps: Array) -> tuple[float, Array]:
    """How much it takes, and the parameters, where a step of one of them is of no use any more (a pattern search)."""
    lower, upper = np.array([(p.lower, p.upper) for p in likeness.effect.parameters(likeness.scene)]).T
    for _ in range(ROUNDS):
        before = gain
        for k in np.flatnonzero(steps):
            for step in (steps[k], -steps[k]):
                tried = theta.copy()
                tried[k] = min(max(theta[k] + step, lower[k]), upper[k])
                found = likeness(tried)
                if found > gain:
                    gain, theta = found, tried
                    break
        if gain == before:
            steps = HALVED * steps
    return gain, theta
