"""Sensor and base do not stand as they are said to: turned adapters, and a floor or a cart that is not level."""

from __future__ import annotations

import numpy as np

from bench.stranger.array import Array
from bench.stranger.draws import draw_direction, draw_log, draw_sign
from bench.stranger.fault import Fault
from bench.stranger.rig import DEGREE, Rig
from bench.stranger.signals import lag_once


def turn_about_tool(rng: np.random.Generator, _: Rig) -> Fault:
    """The sensor, about its own z."""
    angle = draw_sign(rng) * draw_log(rng, 0.6, 1.6) * DEGREE
    return Fault(
        family="sensor_rotation",
        variant="adapter turned about the tool axis (dowel hole)",
        size=lambda scale: {"rotvec_deg": np.r_[0, 0, angle * scale / DEGREE]},
        turn_sensor=lambda scale: np.r_[0, 0, angle * scale],
    )


def turn_about_any_axis(rng: np.random.Generator, _: Rig) -> Fault:
    """The sensor."""
    by = draw_direction(rng) * draw_log(rng, 0.6, 1.6) * DEGREE
    return Fault(
        family="sensor_rotation",
        variant="plate not parallel and turned (general axis)",
        size=lambda scale: {"rotvec_deg": by * scale / DEGREE},
        turn_sensor=lambda scale: by * scale,
    )


def tilt_base(rng: np.random.Generator, rig: Rig) -> Fault:
    """By the same angle all the time."""
    by = _draw_tilt(rng, 0.9)
    return Fault(
        family="base_tilt",
        variant="base not level, constant",
        size=lambda scale: {"rotvec_deg": by * scale / DEGREE},
        turn_gravity=lambda scale: np.broadcast_to(by * scale, (rig.steps, 3)),
    )


def lean_on_rubber_feet(rng: np.random.Generator, rig: Rig) -> Fault:
    """The more, the farther the arm reaches."""
    by = _draw_tilt(rng, 0.8)
    K = rng.uniform(1.2e4, 3e4, 2)

    def lean(scale: float) -> Array:
        M = lag_once(rig.loads.overturning, 0.15)
        return np.asarray(by * scale - np.c_[M[:, 0] / K[0], M[:, 1] / K[1], 0 * M[:, 0]])

    return Fault(
        family="base_tilt",
        variant="cart on rubber feet: constant tilt plus a lean with the overturning moment of the arm",
        size=lambda scale: {"rotvec_deg": by * scale / DEGREE, "foot_stiffness_Nm_per_rad": K},
        turn_gravity=lean,
    )


def _draw_tilt(rng: np.random.Generator, most_deg: float) -> Array:
    """(3,), rotation vector in rad about a horizontal axis."""
    heading = rng.uniform(0, 6.28)
    return np.asarray(draw_log(rng, 0.3, most_deg) * DEGREE * np.r_[np.cos(heading), np.sin(heading), 0])
