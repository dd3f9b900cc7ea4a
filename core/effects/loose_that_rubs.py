"""A part of the payload rubs on a slide and knocks against its stops: a carriage, a drawer, a bolt in its hole."""

from __future__ import annotations

from itertools import product

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.loose_between_stops import LooseBetweenStops
from core.effects.loose_with_knocks import LooseWithKnocks, slide
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import add_force, find_specific_force, load_of_moment

STOPS_M, DRAGS_PER_S, FRICTION_SHARES = (0.003, 0.006, 0.012), (0.5, 10.0), (0.65, 0.8, 1.0)
"""From which fits start along a slide that is known: way, drag, share of its friction."""


class LooseThatRubs(LooseWithKnocks):
    """A part on a slide along e through r, `u'' = -b . e - (h / l) u - c u'` for `|u| < l`, less what dry friction takes; it stops dead
    at either end, until b takes it away again. b is the specific force `a - g` at r; a spring brings it to the end at a load of h.

    Its first moment `d u / l` acts as that of `PayloadLoose`; what it gives to the stops is the second difference of its way.
    """

    beside = LooseBetweenStops
    followed = 3

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Way of the first moment (3) from the middle to a stop, kg m, sensor axes, way of the part, m, its drag, 1/s, the load that
        brings it to the stop and dry friction, m/s2, and place of the middle (3), m, from the centre of mass."""
        plain = super().parameters(scene)
        return (*plain[:6], Parameter("friction_m_per_s2", "m/s2", 0.0, 0.0, 20.0, 3.0), *plain[6:])

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus force and moment about the sensor origin of the part that slides, sensor axes."""
        d, (stop, drag, load, dry), size = theta[:3], theta[3:7], float(np.linalg.norm(theta[:3]))
        if size < 1e-12:
            return w.copy()
        m, r = scene.motion, centre_of_mass(scene) + theta[7:]
        b = find_specific_force(m, r)
        u, _ = slide(b @ d / size, scene.period, stop, drag, load / stop, dry)
        change = np.diff(np.concatenate((u[:1], u, u[-1:])), 2) / scene.period**2  # wherever between rows it knocks
        s, ds, dds = (np.outer(x / stop, d) for x in (u, np.gradient(u, scene.period), change))
        f, tau = load_of_moment(m.omega, m.alpha, b, s, ds, dds)
        return np.asarray(add_force(w, f, r, tau))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """None: along which slide it goes shows without knocks."""
        return []

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """Along the slide that was found: friction is less than that, as part of what it delays is the time on the way."""
        way, held, friction = plain[:3], plain[3], plain[4]
        tried = product(STOPS_M, DRAGS_PER_S, FRICTION_SHARES if friction > 0.0 else (0.0,))
        return [np.array([*way, stop, drag, held, share * friction, *[0.0] * 3]) for stop, drag, share in tried]
