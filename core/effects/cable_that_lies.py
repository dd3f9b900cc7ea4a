"""A hose or cable that lies on the floor: what the arm lifts of it weighs, and the rest is dragged."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.cable_drag import CableDrag
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.words.message import Message

LIFTED = 9
"""Where it stands among the parameters."""
START_N_PER_M = 3.0
"""Of a dress pack; from which fits start."""


class CableThatLies(CableDrag):
    """The cable with a pull downwards that grows with the height of its end, `-lambda h`, h from the first place on, lambda its weight by
    length. From a spring it differs in that ways along the floor cost nothing."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the cable with its weight by length, N/m, in place of the friction of guides."""
        plain = super().parameters(scene)
        return (*plain[:LIFTED], Parameter("lifted_n_per_m", "N/m", 0.0, -2.0, 60.0, 3.0), *plain[LIFTED + 1 :])

    def pull(self, scene: Scene, way: Array, theta: Array) -> Array:
        """(N, 3), N, with the weight of what is lifted."""
        up = -scene.gravity / np.linalg.norm(scene.gravity)
        return np.asarray(super().pull(scene, way, theta) - theta[LIFTED] * np.outer(way @ up, up))

    def rub(self, scene: Scene, F: Array, step: Array, theta: Array) -> Array:
        """(N, 3), N, the pull F (N, 3) with all friction but that of guides."""
        return super().rub(scene, F, step, np.where(np.arange(len(theta)) == LIFTED, 0.0, theta))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The hose of the plain one, lifted, without a spring."""
        hose = super().starts(scene, residual)[0]
        hose[[0, LIFTED]] = 0.0, START_N_PER_M
        return [hose]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As for the cable, stiff as its weight makes it along the vertical."""
        plain = np.where(np.arange(len(theta)) == LIFTED, 0.0, theta)
        plain[0] += theta[LIFTED]
        return super().advice(scene, plain)
