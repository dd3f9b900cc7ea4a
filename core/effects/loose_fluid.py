"""Thick fluid in the payload creeps to the low side: oil or glue in a can that is not full."""

from __future__ import annotations

from itertools import product

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import low_pass
from core.effects.likeness import AXES, find_most_alike
from core.effects.payload_loose import SHARES, PayloadLoose, add_moved
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import find_specific_force
from core.payload.inertia import symmetric
from core.words.message import Message

ROUND_M_PER_S2 = 0.5
"""Specific force up to which a surface rather stays where it is: it takes the edge off one that falls from end to end of a narrow can."""
SETTLING_S = (0.3, 0.8, 2.0, 5.0, 12.0)
"""From which fits start,"""
SLENDERNESS = (1.0, 0.5, 1.0 / 3.0, -0.5)
"""with cans from a narrow tube along an axis to a flat one across it: the part of S that is along the axis only, the rest being even."""
START_KG_M = 0.01
STEPS = np.array([1.0, *[0.3 * START_KG_M] * 6])
"""By which the most promising are moved at first."""
TRIED = 3


class LooseFluid(PayloadLoose):
    """The first moment settles, behind a low-pass, where that of a fluid at rest is: moved by `-S S b / |S b|`, S symmetric, b the specific
    force at the centre of mass.

    That is exact in an ellipsoid, whatever its axes and however full: stretched by S from a ball, in which the fluid is the segment below.
    How it sloshes is left out, and so is a beginning at which it has not settled.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """How long it takes to settle, s, and S (6): how far the fluid moves the first moment from the middle along each axis, kg m."""
        return (
            Parameter("settling_time_s", "s", 1.0, 0.0, 60.0, 5.0),
            *(Parameter(f"first_moment_{axes}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axes in SHARES),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the wrench of the first moment that has moved."""
        S = symmetric(theta[1:])
        if not S.any():
            return w.copy()
        b = find_specific_force(scene.motion, centre_of_mass(scene)) @ S
        length = np.sqrt(np.einsum("ni,ni->n", b, b) + np.square(ROUND_M_PER_S2 * S).sum())
        moved = low_pass(-(b / length[:, None]) @ S, float(theta[0]), scene.period, scene.past("settling"))
        return add_moved(scene, w, moved)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The cans and settling times that look most like the residual."""
        cans = [part * np.outer(axis, axis) + (1.0 - part) * np.eye(3) for part in SLENDERNESS for axis in AXES]
        thetas = (np.array([time, *(START_KG_M * S[np.triu_indices(3)])]) for time, S in product(SETTLING_S, cans))
        return find_most_alike(self, scene, residual, thetas, STEPS, TRIED)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises filling or emptying what it flows in: how far it moves the first moment to either side, kg mm, and in which time, s."""
        first_moment = float(np.abs(np.linalg.eigvalsh(symmetric(theta[1:]))).max())
        return Message.of("advice-payload-loose-fluid", first_moment_kg_m=first_moment, settling_s=float(theta[0]))
