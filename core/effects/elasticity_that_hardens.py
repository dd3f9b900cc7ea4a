"""The joints' springs are soft at first and stiffer under load, as the flexible wheels of harmonic drives are."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.deflection import Spring
from core.effects.effect import Parameter
from core.effects.joint_elasticity import JointElasticity
from core.effects.joint_error import joint_count
from core.effects.scene import Scene

BEGINNINGS = ((1.0, 5e-4), (1.0, 2e-3))
"""By how much stiffer, as a share, and rad from which on, from which fits start,"""
SOFTER = 1.3
"""with compliances that are so many times those that are found as if nothing hardened."""


class ElasticityThatHardens(JointElasticity):
    """The same springs, K at first and (1 + r) K beyond a wind-up of about w: `K (e + r (e - w tanh(e / w)))`.

    Catalogues of harmonic drives state stiffnesses K1 < K2 < K3 with the torques between them; Tuttle and Seering, A nonlinear model of a
    harmonic drive gear transmission, 1996.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the springs, then r and w, the same for all joints."""
        return (
            *super().parameters(scene),
            Parameter("stiffer_under_load_share", "1", 0.0, 0.0, 5.0, 1.0),
            Parameter("wind_up_rad", "rad", 1e-3, 3e-5, 2e-2, 1e-3),
        )

    def find_spring(self, theta: Array) -> Spring:
        """With r and w."""
        return Spring(loaded=float(theta[-2]), wind_up=float(theta[-1]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: it shows where springs that do not harden leave something."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """Springs that are softer than the plain ones, and harden soon or late."""
        n = joint_count(scene)
        return [np.concatenate((SOFTER * plain[:n], plain[n:], beginning)) for beginning in BEGINNINGS]
