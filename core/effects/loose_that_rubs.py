"""A part of the payload rubs on a slide and knocks against its stops: a carriage, a drawer, a bolt in its hole."""

from __future__ import annotations

from itertools import product

import numpy as np
from numba import njit

from core.array import Array
from core.effects.effect import Parameter
from core.effects.loose_between_stops import LooseBetweenStops
from core.effects.loose_with_knocks import START_DRAG_PER_S, START_STOP_M, LooseWithKnocks
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import add_force, find_specific_force, load_of_moment

LONGEST_STEP_S = 0.002
"""Of the integration."""
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
        return (
            *(Parameter(f"first_moment_{axis}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axis in "xyz"),
            Parameter("stop_m", "m", START_STOP_M, 3e-4, 0.1, 0.005),
            Parameter("drag_per_s", "1/s", START_DRAG_PER_S, 0.0, 300.0, 20.0),
            Parameter("holding_load_m_per_s2", "m/s2", 0.0, 0.0, 30.0, 5.0),
            Parameter("friction_m_per_s2", "m/s2", 0.0, 0.0, 20.0, 3.0),
            *(Parameter(f"place_{axis}_m", "m", 0.0, -0.3, 0.3, 0.05) for axis in "xyz"),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus force and moment about the sensor origin of the part that slides, sensor axes."""
        d, (stop, drag, load, dry), size = theta[:3], theta[3:7], float(np.linalg.norm(theta[:3]))
        if size < 1e-12:
            return w.copy()
        m, r = scene.motion, centre_of_mass(scene) + theta[7:]
        b = find_specific_force(m, r)
        u = _slide(b @ d / size, scene.period, stop, drag, load / stop, dry)
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


@njit(cache=True)
def _slide(b: Array, period: float, stop: float, drag: float, spring: float, dry: float) -> Array:
    """Way (N,) of `u'' = -b - spring u - drag u'` between stops that it does not bounce off, b (N,) straight between rows. Dry
    friction is taken off the rate of each step, down to rest (Moreau's time stepping)."""
    steps = max(1, int(np.ceil(period / LONGEST_STEP_S)))
    h, way = period / steps, np.empty_like(b)
    u = -b[0] / spring if spring > 0.0 else -np.sign(b[0]) * stop
    u, v = min(max(u, -stop), stop), 0.0
    for k in range(len(b)):
        for i in range(steps if k > 0 else 0):
            now = b[k - 1] + (b[k] - b[k - 1]) * (i + 0.5) / steps
            v -= h * (now + spring * u)
            v = max(0.0, v - h * dry) if v > 0.0 else min(0.0, v + h * dry)
            v /= 1.0 + h * drag + h * h * spring
            u += h * v
            if abs(u) > stop:
                u, v = stop if u > 0.0 else -stop, 0.0
        way[k] = u
    return way
