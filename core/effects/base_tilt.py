"""The base does not stand level: true gravity is turned against the nominal one."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.payload.rotations import cross, rotate_by, rotation_of
from core.words.message import Message


class BaseTilt(Effect):
    """True gravity is `R(a, b) g0` with the rotation vector (a, b) about two axes of the base frame, those that lie most across gravity.

    The base itself stands turned by the opposite rotation. The arm moves against its base as believed, so only gravity changes:
    `f = -m dg`, `tau = -mc x dg` with `dg` in sensor axes.
    """

    id = "base_tilt"
    title = Message.of("effect-base-tilt-title")
    stage = "mounting"
    only_adds = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Two angles, rad, about the base axes that lie most across gravity; 0 is level."""
        return tuple(Parameter(f"about_{'xyz'[i]}_rad", "rad", 0.0, -0.2, 0.2, 0.015) for i in find_level_axes(scene))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less `m dg` and `mc x dg`, dg the change of gravity in sensor axes."""
        vector = np.zeros(3)
        vector[find_level_axes(scene)] = theta
        return change_gravity(scene, w, (rotation_of(vector) @ scene.gravity - scene.gravity) @ scene.rotation)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises levelling the base by the very angles that are fitted: turning it so takes true gravity to where it is believed to be."""
        i, j = find_level_axes(scene)
        a, b = theta
        return Message.of("advice-base-tilt", first_rad=a, first_axis="xyz"[i], second_rad=b, second_axis="xyz"[j])


def change_gravity(scene: Scene, w: Array, dg: Array) -> Array:
    """`w` less `m dg` and `mc x dg`, dg (N, 3) the change of gravity in sensor axes, m/s2."""
    return np.asarray(w - np.hstack([scene.phi[0] * dg, cross(scene.phi[1:4], dg)]))


def turn_gravity(scene: Scene, w: Array, vectors: Array) -> Array:
    """`w` (N, 6) where gravity is turned row by row, by rotation vectors (N, 3) in base axes, rad."""
    return change_gravity(scene, w, np.einsum("nj,nji->ni", rotate_by(vectors, scene.gravity) - scene.gravity, scene.rotation))


def find_level_axes(scene: Scene) -> list[int]:
    """The two base axes most across gravity."""
    along = int(np.argmax(np.abs(scene.gravity)))
    return [i for i in range(3) if i != along]
