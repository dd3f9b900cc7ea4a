"""A part of the payload slides from stop to stop: a tool in a loose fit, a screw in a box."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.payload_loose import PayloadLoose
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import add_force, find_specific_force, load_of_moment
from core.words.message import Message

LOADS = (0.5, 4.0)
"""m/s2, at which fits start: slides at once, or is held by a spring."""
START_KG_M = 0.005


class LooseBetweenStops(PayloadLoose):
    """The first moment goes by `-d tanh(b . e / b0)`, b the specific force at the centre of mass, e along d: to the one stop or the other
    as gravity has it, gently where a spring holds it back. How it swings on the way, and what it knocks, is left out."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Way of the first moment (3) from the middle to a stop, kg m, sensor axes, and the load that it needs, m/s2."""
        way = (Parameter(f"first_moment_{axis}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axis in "xyz")
        return (*way, Parameter("holding_load_m_per_s2", "m/s2", 1.0, 0.1, 30.0, 5.0))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the wrench of the first moment that has moved."""
        d, size = theta[:3], float(np.linalg.norm(theta[:3]))
        if size < 1e-12:
            return w.copy()
        m, c = scene.motion, centre_of_mass(scene)
        b = find_specific_force(m, c)
        moved = -np.outer(np.tanh(b @ d / (size * theta[3])), d)
        still = np.zeros_like(moved)
        f, tau = load_of_moment(m.omega, m.alpha, m.a - m.g, moved, still, still)
        return np.asarray(add_force(w, f, np.zeros(3), tau))

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """Twins keep the one that swings."""
        return Message.of("effect-shape-of-run")

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Along each axis, sliding at once or held back."""
        return [np.append(START_KG_M * axis, load) for axis in np.eye(3) for load in LOADS]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises fastening the loose part: how far it moves the first moment to either side, kg mm."""
        return Message.of("advice-payload-loose-stops", first_moment_kg_m=float(np.linalg.norm(theta[:3])))
