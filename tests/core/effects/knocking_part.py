"""A part that knocks against its stops, by Newton's law that is written down here and stepped a hundred times as finely."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline

from core.array import Array
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = scene()
FINE = 200
FILM_M_PER_S = 1e-4
"""Speed below which dry friction gives way."""
AXIS, MASS, STOP, PLACE = np.array([0.8, -0.6, 0.0]), 0.4, 0.01, np.array([0.02, -0.03, 0.01])


def knock(drag: float, spring: float, dry: float = 0.0) -> Array:
    """(N, 6), what a part adds on a slide against one that stays in its middle: forces and torques on the mass where it is, its
    acceleration as the change of its speed over a row. Dry friction is that of a very thick film."""
    m, r = RUN.motion, RUN.phi[1:4] / RUN.phi[0] + PLACE
    field = m.a - m.g + np.cross(m.alpha, r) + np.cross(m.omega, np.cross(m.omega, r))
    h, pull = RUN.period / FINE, CubicSpline(RUN.t, field @ AXIS)
    u, v = -STOP * float(np.sign(pull(RUN.t[0]))) if spring == 0.0 else float(-pull(RUN.t[0]) / spring), 0.0
    ways, rates = [], []
    for t in RUN.t:
        ways.append(u)
        rates.append(v)
        for b in pull(t + h * np.arange(FINE)):
            film = dry / max(abs(v - h * (b + spring * u)), FILM_M_PER_S)
            v = (v - h * (b + spring * u)) / (1.0 + h * (drag + film))
            u += h * v
            if abs(u) >= STOP:
                u, v = STOP if u > 0.0 else -STOP, 0.0
    u_e, v_e, a_e = (np.outer(x, AXIS) for x in (ways, rates, np.gradient(rates, RUN.period)))
    at = r + u_e
    there = m.a - m.g + np.cross(m.alpha, at) + np.cross(m.omega, np.cross(m.omega, at)) + 2.0 * np.cross(m.omega, v_e) + a_e
    return MASS * np.hstack((there - field, np.cross(at, there) - np.cross(r, field)))


def average(w: Array) -> Array:
    """(N, 6), over five rows, as windows do, in standard deviations of the noise."""
    return np.asarray(np.apply_along_axis(np.convolve, 0, w / NOISE, np.full(5, 0.2), mode="same"))
