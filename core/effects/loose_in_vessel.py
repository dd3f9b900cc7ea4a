"""A part of the payload swings until it meets a wall: liquid in a can that is half full, a clapper in its bell, a hook on a short chain."""

from __future__ import annotations

from itertools import product

import numpy as np
from numba import njit

from core.array import Array
from core.effects.effect import Parameter
from core.effects.hanging import GRAVITY, accelerate
from core.effects.likeness import AXES, find_most_alike
from core.effects.payload_loose import PayloadLoose
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import add_force, find_specific_force, turn, turn_back
from core.payload.rotations import cross
from core.words.message import Message

LONGEST_STEP_S, MOST_STEPS = 0.004, 16
"""Of the integration, and how many from row to row: so many only in a search, which looks at few rows."""
START_KG_M = 0.005
START_HZ, START_DAMPING, WALLS_RAD = 2.0, 0.1, (0.4, 0.8, 1.4)
"""From which fits start."""
STEPS = np.array([*[0.3 * START_KG_M] * 3, 0.0, 0.0, 0.2, *[0.0] * 3])
"""By which the most promising are moved at first: axis and walls."""
TRIED = 4


class LooseInVessel(PayloadLoose):
    """A part hangs from r, l long, and swings in all directions up to an angle from the axis e of its vessel, where it stops dead and
    slides along the wall: `n'' = -b / l - 2 zeta w (n' - omega x n)` across n, |n| = 1, w^2 = g / l, `n . e >= cos(wall)`.

    b is the specific force `a - g` at r. Liquid that sloshes is such a pendulum (Abramson, NASA SP-106, 1966, chapter 6), and the can is
    its wall. It rests at first, where b has it.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """First moment of the part about r where it lies along the vessel's axis (3), kg m, sensor axes, frequency, Hz, and damping ratio
        of small swings on Earth, angle from the axis to the wall, rad, and place (3), m, from the centre of mass."""
        return (
            *(Parameter(f"first_moment_{axis}_kgm", "kg m", 0.0, -0.5, 0.5, 0.02) for axis in "xyz"),
            Parameter("frequency_hz", "Hz", START_HZ, 0.5, min(10.0, 0.4 / scene.period), 2.0),
            Parameter("damping_ratio", "1", START_DAMPING, 0.003, 1.5, 0.15),
            Parameter("wall_rad", "rad", WALLS_RAD[1], 0.02, np.pi, 0.5),
            *(Parameter(f"place_{axis}_m", "m", 0.0, -0.3, 0.3, 0.05) for axis in "xyz"),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus force and moment about the sensor origin of the part, sensor axes."""
        moment = float(np.linalg.norm(theta[:3]))
        if moment == 0.0:
            return w.copy()
        r = centre_of_mass(scene) + theta[6:]
        R, angular_frequency = scene.rotation, 2.0 * np.pi * theta[3]
        length = GRAVITY / angular_frequency**2
        b, axis = find_specific_force(scene.motion, r), theta[:3] / moment
        rows = np.concatenate((turn(R, b) / -length, turn(R, scene.motion.omega)), axis=1)
        n, change = _swing(rows, R @ axis, scene.period, 2.0 * theta[4] * angular_frequency, theta[5])
        f = moment * turn_back(R, change)
        return np.asarray(add_force(w, f, r, cross(turn_back(R, n), moment * b + length * f)))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The vessels whose part looks most like the residual."""
        thetas = (
            np.array([*(START_KG_M * way * axis), START_HZ, START_DAMPING, wall, *[0.0] * 3])
            for axis, way, wall in product(AXES, (1.0, -1.0), WALLS_RAD)
        )
        return find_most_alike(self, scene, residual, thetas, STEPS, TRIED)

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises fastening or filling: share of the mass, %, frequency, Hz, and the angle to the wall, deg."""
        length = GRAVITY / (2.0 * np.pi * theta[3]) ** 2
        share = float(np.linalg.norm(theta[:3])) / (length * float(scene.phi[0]))
        return Message.of("advice-payload-loose-vessel", mass_share=share, frequency_hz=theta[3], wall_rad=theta[5])


@njit(cache=True)
def _swing(rows: Array, axis: Array, period: float, friction: float, wall: float) -> tuple[Array, Array]:
    """The unit vector from where the part hangs to the part, which rests at first, and its second derivative, 1/s2, (N, 3) each, in axes
    that do not turn. The pull, 1/s2, with the vessel's angular velocity (N, 6), and its axis (N, 3) are straight between rows. What would
    take the part beyond the wall is taken off the rate of each step (Moreau's time stepping), and off the acceleration of the row."""
    steps = min(max(1, int(np.ceil(period / LONGEST_STEP_S))), MOST_STEPS)
    h, far, near = period / steps, np.sin(wall), np.cos(wall)
    places, change = np.empty_like(axis), np.zeros_like(axis)
    v, outward, taken = np.zeros(3), np.zeros(3), np.zeros(3)
    n = rows[0, :3] / max(np.sqrt((rows[0, :3] ** 2).sum()), 1e-9)
    _stop(n, outward, axis[0], far, near)
    places[0] = n
    now, e = np.empty(6), np.empty(3)
    for k in range(1, len(rows)):
        taken[:] = 0.0
        for i in range(steps):
            middle, end = (i + 0.5) / steps, (i + 1.0) / steps
            for c in range(6):
                now[c] = rows[k - 1, c] + middle * (rows[k, c] - rows[k - 1, c])
            for c in range(3):
                e[c] = axis[k - 1, c] + end * (axis[k, c] - axis[k - 1, c])
            ax, ay, az = accelerate(now, n[0], n[1], n[2], v[0], v[1], v[2], friction)
            v[0], v[1], v[2] = v[0] + h * ax, v[1] + h * ay, v[2] + h * az
            n[0], n[1], n[2] = n[0] + h * v[0], n[1] + h * v[1], n[2] + h * v[2]
            one = 1.0 / np.sqrt(_dot(n, n))
            n[0], n[1], n[2] = one * n[0], one * n[1], one * n[2]
            if _stop(n, outward, e, far, near):
                rate = _dot(v, outward)
                rate -= outward[0] * (now[4] * n[2] - now[5] * n[1])
                rate -= outward[1] * (now[5] * n[0] - now[3] * n[2])
                rate -= outward[2] * (now[3] * n[1] - now[4] * n[0])
                for c in range(3):
                    off = max(0.0, rate) * outward[c]
                    v[c], taken[c] = v[c] - off, taken[c] + off
            along = _dot(v, n)
            v[0], v[1], v[2] = v[0] - along * n[0], v[1] - along * n[1], v[2] - along * n[2]
        places[k] = n
        change[k] = accelerate(rows[k], n[0], n[1], n[2], v[0], v[1], v[2], friction)
        change[k] -= taken / period
    return places, change


@njit(cache=True)
def _stop(n: Array, outward: Array, axis: Array, far: float, near: float) -> bool:
    """Whether n is beyond the wall; it is put back to it then, and `outward` is the way across n on which it would go on."""
    along = _dot(n, axis)
    if along >= near:
        return False
    for c in range(3):
        outward[c] = n[c] - along * axis[c]
    one = 1.0 / max(np.sqrt(_dot(outward, outward)), 1e-9)
    for c in range(3):
        across = one * outward[c]
        n[c], outward[c] = near * axis[c] + far * across, near * across - far * axis[c]
    return True


@njit(cache=True)
def _dot(x: Array, y: Array) -> float:
    return float(x[0] * y[0] + x[1] * y[1] + x[2] * y[2])
