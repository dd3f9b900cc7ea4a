"""The base leans as the arm moves: a cart on rubber feet, a thin plate, a slender column."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.base_tilt import BaseTilt, find_level_axes, turn_gravity
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.words.message import Message

START_RAD_PER_NM = 5e-5
"""A stiffness of 20 kN m/rad."""


class BaseThatLeans(BaseTilt):
    """`BaseTilt` by `(a, b) - (c_a dM_a, c_b dM_b)`: the base turns with the moment M of the weights of arm and payload about its origin,
    true gravity against it. dM is how M has changed since the first row; what the arm's accelerations add is left out.
    """

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The two angles of the tilt in the first row, rad, then the compliance about the same axes, rad/(N m)."""
        lean = (Parameter(f"lean_{'xyz'[i]}_rad_per_nm", "rad/(N m)", 0.0, 0.0, 2e-3, 5e-5) for i in find_level_axes(scene))
        return (*super().parameters(scene), *lean)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less `m dg` and `mc x dg`, dg the change of gravity in sensor axes, row by row."""
        axes, vectors = find_level_axes(scene), np.zeros((len(scene), 3))
        moment = find_moment(scene)[:, axes]
        vectors[:, axes] = theta[:2] - theta[2:] * (moment - moment[0])
        return turn_gravity(scene, w, vectors)

    def explain_lack(self, scene: Scene) -> Message | None:
        """A reason where it is not known what weighs on the base, and where."""
        if scene.position is None:
            return Message.of("effect-no-position")
        return Message.of("effect-no-masses") if scene.links is None else None

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Level, and leaning as on rubber; nothing where the masses of the arm or its place are not known."""
        if self.explain_lack(scene) is not None:
            return []
        return [np.array([0.0, 0.0, START_RAD_PER_NM, START_RAD_PER_NM])]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises fastening the base, with the most that it leans in the run to and fro, deg, then levelling it."""
        angles = theta[2:] * np.ptp(find_moment(scene)[:, find_level_axes(scene)], axis=0)
        return Message.of("advice-base-tilt-leans", lean_rad=float(angles.max()))


def find_moment(scene: Scene) -> Array:
    """(N, 3), N m, of the weights of arm and payload about the base's origin, base axes."""
    if scene.position is None or scene.links is None:
        raise ValueError("the moment on the base needs positions and the arm's masses (see Effect.explain_lack)")
    carried = scene.phi[0] * scene.position + scene.rotation @ scene.phi[1:4]
    return np.asarray(np.cross(scene.links.loads.moment + carried, scene.gravity))
