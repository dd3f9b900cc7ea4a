"""No family describes these, and they lie in the tool, in its air and fluids, and in what it is near to."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction, list_stretches
from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_moved_part_wrench, find_point_wrench, push
from bench.second_stranger.signals import STEP_S, lag, rise

WEIGHT_PER_KG = 9.81
FILM_M = 0.05
TOP_HZ = 11.0
"""Of the spindle; above what the slowest logs would show."""


def _press(rig: Rig, shape: Array, along: Array, at: Array, what: str) -> Fault:
    """Forces in the tool along (3,) at a place (3,), m, both sensor axes, as a tenth of the payload's weight times a shape (N,)."""
    force = 0.1 * rig.body.mass * WEIGHT_PER_KG
    wrench = np.outer(shape, np.concatenate([along, np.cross(at, along)]))
    most = float(np.max(np.abs(shape)))
    return Fault(size=lambda scale: Size(what, force * scale * most, "N"), touch=lambda W, _, scale: W + force * scale * wrench)


def u_valve(rng: np.random.Generator, rig: Rig) -> Fault:
    """A hose across the sensor straightens as the gripper's valve opens: on and off from stop to stop."""
    pressure = np.zeros((len(rig.t), 1))
    for place, stop in enumerate(list_stretches(rig, "hold", 0.05, 0.97)):
        pressure[int(stop.begin_s / STEP_S) + 200 :] = place % 2
    at = rig.body.com * 0.4 + 0.5 * float(np.linalg.norm(rig.body.com)) * draw_direction(rng)
    return _press(rig, lag(pressure, 0.12)[:, 0], draw_direction(rng), at, "force of a hose under pressure, on and off")


def u_compressor(rng: np.random.Generator, rig: Rig) -> Fault:
    """The air in the tool follows its compressor: it falls as it is used, and is pumped up again within a second, over and over."""
    period_s = rng.uniform(5, 8)
    x = np.mod(rig.t / period_s, 1)
    sawtooth = np.where(x < 0.85, 1 - x / 0.85, (x - 0.85) / 0.15)
    return _press(
        rig,
        sawtooth - 0.5,
        normalise([0.2, -0.1, 1]),
        0.3 * draw_direction(rng) * np.linalg.norm(rig.body.com),
        "force of the air, half span",
    )


def u_unbalance(rng: np.random.Generator, rig: Rig) -> Fault:
    """A worn wheel runs up, grinds and runs down, four times: its unbalance turns with it, and grows with the square of its speed."""
    hz = np.zeros(len(rig.t))
    for middle in (0.1, 0.33, 0.56, 0.79):
        begin = (middle + rng.uniform(-0.03, 0.03)) * rig.seconds
        hz += TOP_HZ * rise((rig.t - begin) / 3) * rise((begin + 0.16 * rig.seconds - rig.t) / 4)
    angle = 2 * np.pi * np.cumsum(hz) * STEP_S
    first = draw_direction(rng)
    second = np.cross(first, normalise(np.cross(first, rig.body.com)))
    at, force = 1.3 * rig.body.com, 0.05 * rig.body.mass * WEIGHT_PER_KG
    turning = (hz / TOP_HZ)[:, None] ** 2 * (np.outer(np.cos(angle), first) + np.outer(np.sin(angle), second))
    wrench = np.hstack([turning, np.cross(at, turning)])
    return Fault(
        size=lambda scale: Size(f"force of an unbalance at {TOP_HZ:g} Hz", force * scale, "N"),
        touch=lambda W, _, scale: W + force * scale * wrench,
    )


def u_runup(rng: np.random.Generator, rig: Rig) -> Fault:
    """A screwdriver starts and is stopped again and again: what turns its rotor turns the tool back, and at speed it is a gyroscope."""
    axis = draw_direction(rng)
    speed = np.zeros(len(rig.t))
    for middle in np.linspace(0.06, 0.93, 11):
        begin = (middle + rng.uniform(-0.02, 0.02)) * rig.seconds
        speed += rise((rig.t - begin) / 0.5) * rise((begin + 2.2 - rig.t) / 0.15)
    spin = 0.02 * rig.body.mass * WEIGHT_PER_KG * float(np.linalg.norm(rig.body.com))
    rate = np.gradient(speed, STEP_S)

    def turn_back(W: Array, k: Kinematics, scale: float) -> Array:
        torque = np.outer(rate, axis) + np.cross(k.omega, np.outer(speed, axis))
        return W + scale * spin * np.hstack([0 * torque, torque])

    return Fault(size=lambda scale: Size("angular momentum of a rotor at speed", scale * spin, "N m s"), touch=turn_back)


def u_bath(rng: np.random.Generator, rig: Rig) -> Fault:
    """The tool dips into a bath: the deeper, the more it is borne, and what moves in it is held back."""
    point = 1.2 * rig.body.com
    up = -normalise(rig.gravity)
    height = rig.nominal.find_place(point) @ up
    level, depth = float(np.quantile(height, 0.45)), 0.3 * float(np.ptp(height))
    weight = rig.body.mass * WEIGHT_PER_KG
    share = 0.06 * rng.uniform(0.8, 1.2)

    def bear(W: Array, k: Kinematics, scale: float) -> Array:
        within = rise((level - k.find_place(point) @ up) / depth)[:, None]
        return push(W, k, scale * weight * within * (share * up - 0.02 * k.find_speed(point)), point)

    return Fault(size=lambda scale: Size("buoyancy of the whole tool", scale * share * weight, "N"), touch=bear)


def u_film(rng: np.random.Generator, rig: Rig) -> Fault:
    """Film on the tool is charged and drawn to a grounded post, by the square of how near it is; it is charged anew at every stop."""
    point, weight = 1.2 * rig.body.com, rig.body.mass * WEIGHT_PER_KG
    place = rig.nominal.find_place(point)
    post = place[int(rng.uniform(0.3, 0.7) * len(place))] + 0.15 * float(np.linalg.norm(np.ptp(place, axis=0))) * draw_direction(rng)
    least = float(np.min(np.linalg.norm(place - post, axis=1))) + FILM_M
    charge = np.zeros(len(rig.t))
    for stop in list_stretches(rig, "hold", 0.0, 1.0):
        since = rig.t - stop.begin_s
        charge = np.where(since > 0, np.exp(-since / 3), charge)

    def draw_near(W: Array, k: Kinematics, scale: float) -> Array:
        to = post - k.find_place(point)
        away = np.linalg.norm(to, axis=1, keepdims=True)
        pull = (charge**2)[:, None] * (least / (away + FILM_M)) ** 2
        return push(W, k, 0.2 * scale * weight * pull * to / away, point)

    return Fault(size=lambda scale: Size("force of a charged film nearest to its post", 0.2 * scale * weight, "N"), touch=draw_near)


def u_slider(rng: np.random.Generator, rig: Rig) -> Fault:
    """A slide in the tool shuttles by its own program, out and back many times."""
    along, mass, period_s = draw_direction(rng), 0.2 * rig.body.mass, rng.uniform(4, 6)
    x = np.mod(rig.t / period_s, 1) * period_s
    stroke = 0.02 * (rise((x - 0.5) / 0.5) - rise((x - 0.55 * period_s) / 0.5))
    return Fault(
        size=lambda scale: Size("stroke of a slide with a fifth of the mass, over and over", 20 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rig.body.com, scale * np.outer(stroke, along)),
    )


def u_cycle(rng: np.random.Generator, rig: Rig) -> Fault:
    """Parts are picked and placed in every cycle, while the tool is taken for the payload: their mass comes and goes."""
    held = np.zeros((len(rig.t), 1))
    for place, stop in enumerate(list_stretches(rig, "hold", 0.03, 0.97)):
        held[int((stop.begin_s + stop.end_s) / 2 / STEP_S) :] = place % 2
    held = lag(held, 0.03)
    at, mass = 1.5 * rig.body.com + 0.2 * float(np.linalg.norm(rig.body.com)) * draw_direction(rng), 0.06 * rig.body.mass
    return Fault(
        size=lambda scale: Size("mass of parts that are picked and placed in turn", 1e3 * scale * mass, "g"),
        change_payload=lambda W, k, scale: W + scale * mass * held * find_point_wrench(k, at),
    )


def u_airlock(rng: np.random.Generator, rig: Rig) -> Fault:
    """The sealed sensor is a barometer: doors of the clean room open and the pressure falls, then is slowly made good."""
    pressure = np.zeros(len(rig.t))
    for middle in (0.12, 0.3, 0.42, 0.66, 0.85):
        since = np.maximum(rig.t - (middle + rng.uniform(-0.04, 0.04)) * rig.seconds, 0)
        pressure += (1 - np.exp(-since / 0.2)) * np.exp(-since / 2.2)
    return _press(rig, pressure, normalise([0.05, 0.08, 1]), np.zeros(3), "force that air pressure feigns")
