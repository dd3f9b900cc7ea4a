"""A body that slides on springs along axes of the sensor: what its motion adds to the wrench, by an adaptive integrator."""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from core.payload.inertia import Motion

Array = np.ndarray


def wrench_of_slides(t: Array, motion: Motion, mass: float, com: Array, along: Array, hz: Array, zeta: float) -> Array:
    """(N, 6), change of the wrench against the same body held rigidly, to first order in the deflection and without its part in rotation.

    Args:
        t: (N,), s.
        motion: of the sensor.
        mass, com: of the body, kg and (3,), m.
        along: (K, 3), axes of the slides, orthogonal and of unit length.
        hz, zeta: (K,), natural frequencies, Hz; share of the critical damping.
    """
    omega, field = 2 * np.pi * hz, motion.a - motion.g
    at_com = field + np.cross(motion.alpha, com) + np.cross(motion.omega, np.cross(motion.omega, com))
    force = CubicSpline(t, at_com @ along.T)

    def acceleration(t: float, u: Array, du: Array) -> Array:
        return -force(t) - 2 * zeta * omega * du - omega**2 * u

    def rate(t: float, state: Array) -> Array:
        u, du = state.reshape(2, -1)
        return np.append(du, acceleration(t, u, du))

    start = np.append(-force(t[0]) / omega**2, np.zeros(len(omega)))
    u, du = solve_ivp(rate, (t[0], t[-1]), start, t_eval=t, rtol=1e-9, atol=1e-12).y.reshape(2, len(omega), -1)
    push = mass * acceleration(t, u.T, du.T) @ along
    return np.hstack([push, np.cross(com, push) + mass * np.cross(u.T @ along, field)])
