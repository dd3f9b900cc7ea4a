"""A part of the payload turns on a hinge and hangs with its heavy side down: a lid, a handle, a reel or a roller that is not balanced."""

from __future__ import annotations

from itertools import product

import numpy as np
from numba import njit

from core.array import Array
from core.effects.effect import Parameter
from core.effects.hanging import GRAVITY
from core.effects.likeness import AXES, find_most_alike
from core.effects.payload_loose import PayloadLoose
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import add_force, find_specific_force, load_of_moment
from core.payload.inertia import Motion
from core.words.message import Message

LONGEST_STEP_S, MOST_STEPS = 0.0025, 16
"""Of the integration, and how many from row to row: so many only in a search, which looks at few rows."""
START_KG_M = 0.005
START_HZ, START_DAMPING, FRICTIONS = 2.0, 0.2, (0.1, 0.4)
"""From which fits start."""
TURNS_RAD = (0.0, 0.5 * np.pi, np.pi, -0.5 * np.pi)
"""From hanging down, at the beginning: an axis that stands upright lets it be anywhere."""
FREE_RAD = 2.0 * np.pi
"""Where there is no stop."""
STOPS_RAD = ((FREE_RAD, FREE_RAD), (0.0, 1.0), (1.0, 0.0), (0.5, 0.5))
"""How far it turns back and forth from where it begins: all the way, from one stop to another, or to both."""
STEPS = np.array([*[0.3 * START_KG_M] * 3, 0.0, 0.0, 0.1, 0.4, *[0.0] * 3, 0.4, 0.4])
"""By which the most promising are moved at first: axis, friction, where it begins, and stops."""
TRIED = 6


class LooseOnHinge(PayloadLoose):
    """A part on a hinge along e through r, its centre of mass along u across e, |u| = 1:
    `phi'' = -(w^2 / g) e . (u x b) - e . alpha - 2 zeta w phi'`, less what dry friction takes, up to that of the share `mu` of its weight;
    it stops dead where it can turn no further.

    b is the specific force `a - g` at r, and w that of small swings under gravity with the axis level. What it moves of the first moment
    acts as that of `PayloadLoose`; about e the hinge passes on what the part's inertia `d g / w^2` takes to turn, d its first moment.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """First moment of the part (3), kg m, along the axis that it turns about, sensor axes, frequency, Hz, damping ratio, dry friction,
        a share of what its weight does, how far from hanging down it begins, rad, the hinge's place (3), m, from the centre of mass, and
        how far it can turn back and forth from where it begins, rad."""
        return (
            *(Parameter(f"first_moment_{axis}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axis in "xyz"),
            Parameter("frequency_hz", "Hz", START_HZ, 0.3, min(10.0, 0.4 / scene.period), 2.0),
            Parameter("damping_ratio", "1", START_DAMPING, 0.003, 3.0, 0.2),
            Parameter("friction_share", "1", FRICTIONS[0], 0.0, 1.0, 0.1),
            Parameter("start_rad", "rad", 0.0, -1.5 * np.pi, 1.5 * np.pi, 1.0),
            *(Parameter(f"place_{axis}_m", "m", 0.0, -0.3, 0.3, 0.05) for axis in "xyz"),
            *(Parameter(f"stop_{way}_rad", "rad", FREE_RAD, 0.0, FREE_RAD, 1.0) for way in ("back", "forth")),
        )

    def smaller_shape(self, scene: Scene) -> int | None:
        """Without stops."""
        return 10

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus force and moment about the sensor origin of what has turned since the first row, sensor axes."""
        if not theta[:3].any():
            return w.copy()
        r = centre_of_mass(scene) + theta[7:10]
        force, torque = _compute_load(scene.motion, r, scene.period, theta)
        return np.asarray(add_force(w, force, r, torque))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The hinges whose part looks most like the residual."""
        thetas = (
            np.array([*(START_KG_M * axis), START_HZ, START_DAMPING, friction, turn, *[0.0] * 3, *stops])
            for axis, friction, turn, stops in product(AXES, FRICTIONS, TURNS_RAD, STOPS_RAD)
        )
        return find_most_alike(self, scene, residual, thetas, STEPS, TRIED)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises fastening the part that turns: its first moment, kg mm."""
        return Message.of("advice-payload-loose-hinge", first_moment_kg_m=float(np.linalg.norm(theta[:3])))


def _compute_load(motion: Motion, r: Array, period: float, theta: Array) -> tuple[Array, Array]:
    """Force at r (3,) and torque beside it, (N, 3) each, of what has turned since the first row."""
    moment, w = float(np.linalg.norm(theta[:3])), 2.0 * np.pi * theta[3]
    e = theta[:3] / moment
    b = find_specific_force(motion, r)
    down = -b[0] + (b[0] @ e) * e
    if down @ down < 1e-12:  # exactly upright: any direction is as good
        down = np.cross(e, np.roll(e, 1) + np.array([0.0, 0.1, 0.2]))
    u = down / np.linalg.norm(down)
    v = np.cross(e, u)
    angle, rate = _turn(
        b @ u, b @ v, motion.alpha @ e, period, w * w / GRAVITY, 2.0 * theta[4] * w, theta[5] * w * w, theta[6], theta[10], theta[11]
    )
    change = np.gradient(rate, period)
    force, torque = load_of_moment(motion.omega, motion.alpha, b, *_move(angle, rate, change, moment * u, moment * v))
    return force, torque + (moment * GRAVITY / (w * w) * change)[:, None] * e


@njit(cache=True)
def _move(angle: Array, rate: Array, change: Array, u: Array, v: Array) -> tuple[Array, Array, Array]:
    """(N, 3) each, how far a first moment has moved since the first row, and its two rates, that turns from u (3,) towards v (3,)."""
    s, ds, dds = np.empty((len(angle), 3)), np.empty((len(angle), 3)), np.empty((len(angle), 3))
    cos0, sin0 = np.cos(angle[0]), np.sin(angle[0])
    for k in range(len(angle)):
        cos, sin, one, two = np.cos(angle[k]), np.sin(angle[k]), rate[k], change[k]
        for c in range(3):
            at, across = cos * u[c] + sin * v[c], cos * v[c] - sin * u[c]
            s[k, c] = at - cos0 * u[c] - sin0 * v[c]
            ds[k, c] = one * across
            dds[k, c] = two * across - one * one * at
    return s, ds, dds


@njit(cache=True)
def _turn(
    p: Array, q: Array, alpha: Array, period: float, pull: float, drag: float, dry: float, start: float, back: float, forth: float
) -> tuple[Array, Array]:
    """Angle, rad, and rate, rad/s, (N,) of a part that rests at first; p and q (N,) are the specific force along where it hangs at
    first and a quarter turn further, alpha (N,) the angular acceleration about the axis, straight between rows. Dry friction is taken off
    the rate of each step, down to rest (Moreau's time stepping); it stops dead so far back or forth from the start, rad."""
    steps = min(max(1, int(np.ceil(period / LONGEST_STEP_S))), MOST_STEPS)
    h, angle, rate = period / steps, np.empty_like(p), np.empty_like(p)
    phi, v, sin, cos = start, 0.0, np.sin(start), np.cos(start)
    for k in range(len(p)):
        for i in range(steps if k > 0 else 0):
            share = (i + 0.5) / steps
            now_p, now_q = p[k - 1] + share * (p[k] - p[k - 1]), q[k - 1] + share * (q[k] - q[k - 1])
            turning = pull * (sin * now_p - cos * now_q) - alpha[k - 1] - share * (alpha[k] - alpha[k - 1])
            v = (v + h * turning) / (1.0 + h * drag)
            v = max(0.0, v - h * dry) if v > 0.0 else min(0.0, v + h * dry)
            phi += h * v
            if phi < start - back or phi > start + forth:
                phi, v = min(max(phi, start - back), start + forth), 0.0
                sin, cos = np.sin(phi), np.cos(phi)
            elif v != 0.0:  # what rests needs no new ones
                sin, cos = np.sin(phi), np.cos(phi)
        angle[k], rate[k] = phi, v
    return angle, rate
