"""The joints' springs wind up on another line than they unwind, however slowly, as the flexible wheels of harmonic drives do."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.deflection import Spring
from core.effects.effect import Parameter
from core.effects.joint_elasticity import JointElasticity
from core.effects.scene import Scene

BEGINNINGS = ((1.0, 3e-4), (1.0, 1e-3), (1.0, 3e-3))
"""Loss, and rad over which it comes, from which fits start."""


class ElasticityThatLoses(JointElasticity):
    """The same springs with Dahl's friction beside each: 1 + r times as stiff after a turn back, until they have given way by about b.

    Dahl, A solid friction model, 1968; hysteresis of harmonic drives: Tuttle and Seering, 1996.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the springs, then r and b, the same for all joints."""
        return (
            *super().parameters(scene),
            Parameter("stiffer_after_turn_share", "1", 0.0, 0.0, 5.0, 1.0),
            Parameter("turn_back_rad", "rad", 1e-3, 3e-5, 2e-2, 1e-3),
        )

    def find_spring(self, theta: Array) -> Spring:
        """With r and b."""
        return Spring(turned=float(theta[-2]), bend=float(theta[-1]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where springs that lose nothing leave something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The plain springs, with losses that come soon or late."""
        return [np.concatenate((plain, beginning)) for beginning in BEGINNINGS]
