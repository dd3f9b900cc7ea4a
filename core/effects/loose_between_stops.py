"""A part of the payload slides from stop to stop: a tool in a loose fit, a screw in a box."""

from __future__ import annotations

from itertools import product

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.filters import play
from core.effects.likeness import AXES, find_most_alike
from core.effects.payload_loose import PayloadLoose, add_moved
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import find_specific_force
from core.words.message import Message

LOADS = (0.5, 4.0)
"""m/s2, at which fits start: slides at once, or is held by a spring;"""
FRICTIONS = (0.0, 1.0, 2.5, 4.5, 7.0)
"""and so much dry friction, m/s2."""
START_KG_M = 0.005
STEPS = np.array([*[0.3 * START_KG_M] * 3, 1.0, 1.0])
"""By which the most promising are moved at first."""
TRIED = 3


class LooseBetweenStops(PayloadLoose):
    """The first moment goes by `-d tanh(p / b0)`, p the play of `b . e`, b the specific force at the centre of mass, e along d: to the
    one stop or the other as gravity has it, gently where a spring holds it back.

    Dry friction is the half width of the play: without a spring the part stays at its stop until the load the other way has overcome it.
    How it swings on the way, and what it knocks, is left out.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Way of the first moment (3) from the middle to a stop, kg m, sensor axes, the load that it needs, and dry friction, m/s2."""
        return (
            *(Parameter(f"first_moment_{axis}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axis in "xyz"),
            Parameter("holding_load_m_per_s2", "m/s2", 1.0, 0.1, 30.0, 5.0),
            Parameter("friction_m_per_s2", "m/s2", 0.0, 0.0, 20.0, 3.0),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the wrench of the first moment that has moved."""
        d, size = theta[:3], float(np.linalg.norm(theta[:3]))
        if size < 1e-12:
            return w.copy()
        b = find_specific_force(scene.motion, centre_of_mass(scene))
        moved = -np.tanh(play((b @ d / size)[:, None], theta[4:], scene.past("friction")) / theta[3]) * d
        return add_moved(scene, w, np.asarray(moved))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Along which axis, held by which loads, it looks most like the residual."""
        thetas = (np.array([*(START_KG_M * axis), *loads]) for axis, *loads in product(AXES, LOADS, FRICTIONS))
        return find_most_alike(self, scene, residual, thetas, STEPS, TRIED)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises fastening the loose part: how far it moves the first moment to either side, kg mm."""
        return Message.of("advice-payload-loose-stops", first_moment_kg_m=float(np.linalg.norm(theta[:3])))
