"""The payload is not one rigid body for all of the time: parts that are loose, slip, fall off or swing, and tools that bend."""

from __future__ import annotations

import math

import numpy as np
from scipy import signal

from bench.stranger.array import Array
from bench.stranger.draws import draw_direction, draw_sign
from bench.stranger.fault import Change, Fault
from bench.stranger.kinematics import Kinematics
from bench.stranger.rig import DEGREE, Rig
from bench.stranger.rigid_body import find_part_wrench, find_steiner
from bench.stranger.rotations import rotate_by_vector
from bench.stranger.signals import STEP_S, filter_from_rest, lag_once, lag_twice, step_softly

STICKING = 1e-4
"""m/s, below which a part on a rail is held by friction."""
STOP_RATE = 300.0
"""rad/s, natural frequency of a part against a stop of its rail, half damped."""


def add_moved_part(k: Kinematics, rest: Array, place: Array, acceleration: Array, mass: float) -> Array:
    """(N, 6), N and N m: what a part in kg, whose place at rest (3,) belongs to the payload, asks for at places (N, 3) beyond that."""
    at_rest = np.broadcast_to(rest, place.shape)
    return find_part_wrench(k, place, acceleration, mass) - find_part_wrench(k, at_rest, 0.0, mass)


def slide_on_rail(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part between two stops."""
    axis = draw_direction(rng)
    stroke, mu = rng.uniform(0.004, 0.012), rng.uniform(0.1, 0.3)
    mass = rng.uniform(0.1, 0.25) * rig.body.mass
    rest = rig.body.com + rng.uniform(-0.03, 0.03, 3)

    def slide(k: Kinematics, scale: float) -> Array:
        along = -(k.u @ axis)
        across = np.linalg.norm(k.u + np.outer(along, axis), axis=1)
        x, a = _slide(along, across, stroke * scale, mu)
        a = lag_twice(a, 60)
        return add_moved_part(k, rest, rest + x[:, None] * axis, a[:, None] * axis, mass)

    return Fault(
        family="payload_loose",
        variant="a part slides between two stops along a rail with Coulomb friction and knocks on the stops",
        size=lambda scale: {"mass": mass, "half_stroke_m": stroke * scale, "mu": mu, "axis": axis},
        add_wrench=slide,
        limits=(0.3, 3),
    )


def _slide(along: Array, across: Array, stroke: float, mu: float) -> tuple[Array, Array]:
    """Place in m and acceleration in m/s^2, (N,) each, of a part that is pulled along its rail by (N,) and pressed on it by (N,), m/s^2."""
    x, a = np.empty(len(along)), np.empty(len(along))
    place, speed, h = stroke * float(np.sign(along[0])), 0.0, STEP_S / 4
    for i, (pull, press) in enumerate(zip(along.tolist(), across.tolist(), strict=True)):
        mean = 0.0
        for _ in range(4):
            free = pull
            if abs(place) > stroke:
                free -= STOP_RATE**2 * (place - stroke * (1 if place > 0 else -1)) + STOP_RATE * speed
            friction = mu * press
            if abs(speed) < STICKING and abs(free) < friction:
                acceleration = speed = 0.0
            else:
                acceleration = free - friction * max(-1.0, min(1.0, speed / STICKING))
                speed = max(-1.0, min(1.0, speed + h * acceleration))
            place += h * speed
            mean += acceleration / 4
        x[i], a[i] = place, mean
    return x, a


def swing_on_hinge(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part between two stops, with friction."""
    axis = draw_direction(rng)
    n1 = np.cross(axis, draw_direction(rng))
    n1 /= np.linalg.norm(n1)
    n2 = np.cross(axis, n1)
    arm = rng.uniform(0.02, 0.05)
    hinge = rig.body.com + rng.uniform(-0.03, 0.03, 3)
    mass = rng.uniform(0.04, 0.10) * rig.body.mass
    stop, damping = rng.uniform(0.5, 1.2), rng.uniform(0.04, 0.12)

    def swing(k: Kinematics, scale: float) -> Array:
        angle, rate, turning = _swing(-(k.u @ n1), -(k.u @ n2), arm, stop, damping)
        out = np.cos(angle)[:, None] * n1 + np.sin(angle)[:, None] * n2
        ahead = -np.sin(angle)[:, None] * n1 + np.cos(angle)[:, None] * n2
        acceleration = arm * (turning[:, None] * ahead - (rate**2)[:, None] * out)
        return scale * add_moved_part(k, hinge + arm * n1, hinge + arm * out, acceleration, mass)

    return Fault(
        family="payload_loose",
        variant="a hinged part swings between stops with friction in the hinge",
        size=lambda scale: {"mass": mass * scale, "arm_m": arm, "stop_rad": stop, "axis": axis},
        add_wrench=swing,
        limits=(0.2, 4),
    )


def _swing(pull_1: Array, pull_2: Array, arm: float, stop: float, damping: float) -> tuple[Array, Array, Array]:
    """Angle and its derivatives, (N,) each, rad and s, of a pendulum of a length in m that is pulled (N,), m/s^2, along two axes."""
    natural = float(np.sqrt(9.81 / arm))
    found = np.empty((3, len(pull_1)))
    angle = rate = 0.0
    for i, (p1, p2) in enumerate(zip(pull_1.tolist(), pull_2.tolist(), strict=True)):
        free = (-math.sin(angle) * p1 + math.cos(angle) * p2) / arm
        turning = free - 2 * damping * natural * rate - 0.6 * max(-1, min(1, rate / 0.02))
        if abs(angle) > stop:
            turning -= 3600 * (angle - math.copysign(stop, angle)) + 30 * rate
        rate += STEP_S * turning
        angle += STEP_S * rate
        found[:, i] = angle, rate, turning
    return found[0], found[1], found[2]


def creep_to_low_side(rng: np.random.Generator, rig: Rig) -> Fault:
    """A thick fluid."""
    mass = rng.uniform(0.15, 0.3) * rig.body.mass
    travel, tau_s = rng.uniform(0.005, 0.015), rng.uniform(2.5, 7)

    def flow(k: Kinematics, scale: float) -> Array:
        low = -k.u / np.linalg.norm(k.u, axis=1)[:, None] * travel * scale
        x = lag_once(low, tau_s) * np.r_[1, 1, 0.6]
        return np.hstack([0 * x, np.cross(x, mass * k.u)])

    return Fault(
        family="payload_loose",
        variant="thick fluid in a can creeps to the low side (time constant of seconds)",
        size=lambda scale: {"mass": mass, "travel_m": travel * scale, "tau_s": tau_s},
        add_wrench=flow,
        limits=(0.3, 3),
    )


def slip_in_jaws(rng: np.random.Generator, rig: Rig) -> Fault:
    """Once, along a line."""
    at_s = rng.uniform(0.35, 0.65) * rig.seconds
    by = draw_direction(rng) * rng.uniform(0.004, 0.012)
    mass = rng.uniform(0.3, 0.6) * rig.body.mass
    lasting_s = rng.uniform(0.4, 1.5)
    x = np.clip((rig.t - at_s) / lasting_s, 0, 1)
    y = x**1.6 * (2.6 - 1.6 * x)
    return Fault(
        family="payload_shift",
        variant="workpiece slips in the jaws over 0.4-1.5 s (stick at the end)",
        size=lambda scale: {"t0": at_s, "duration_s": lasting_s, "mass": mass, "shift_m": by * scale},
        change_payload=lambda scale: Change(0.0, mass * y[:, None] * by * scale, np.zeros((3, 3))),
        limits=(0.3, 4),
    )


def turn_in_gripper(rng: np.random.Generator, rig: Rig) -> Fault:
    """Once, by 12 to 30 degrees."""
    at_s = rng.uniform(0.35, 0.65) * rig.seconds
    axis, angle = draw_direction(rng), rng.uniform(12, 30) * DEGREE
    mass = 0.5 * rig.body.mass
    arm = rig.body.com + rng.uniform(-0.02, 0.02, 3) - rig.body.com * 0.6
    y = step_softly(rig.t, at_s, 0.06)

    def find_step(scale: float) -> Array:
        return np.asarray(mass * ((rotate_by_vector(axis * angle * scale) - np.eye(3)) @ arm))

    return Fault(
        family="payload_shift",
        variant="part turns in the gripper within 0.3 s and stays there",
        size=lambda scale: {"t0": at_s, "angle_deg": angle * scale / DEGREE, "first_moment_step": find_step(scale)},
        change_payload=lambda scale: Change(0.0, y[:, None] * find_step(scale), np.zeros((3, 3))),
        limits=(0.5, 4),
    )


def lose_part(rng: np.random.Generator, rig: Rig) -> Fault:
    """It falls off."""
    at_s = rng.uniform(0.3, 0.7) * rig.seconds
    mass = -rng.uniform(0.06, 0.15)
    place = rig.body.com + rng.uniform(-0.05, 0.05, 3)
    y = 1 / (1 + np.exp(-np.clip((rig.t - at_s) / rng.uniform(0.05, 0.4) * 4, -50, 50)))
    return Fault(
        family="payload_mass_change",
        variant="a part falls off (over 0.1-0.5 s)",
        size=lambda scale: {"t0": at_s, "dm": mass * scale, "at": place},
        change_payload=lambda scale: _change_by_point(mass * scale * y, place),
        limits=(0.2, 2.5),
    )


def pour(rng: np.random.Generator, rig: Rig) -> Fault:
    """Out or in, once."""
    at_s = rng.uniform(0.3, 0.55) * rig.seconds
    mass = draw_sign(rng) * rng.uniform(0.06, 0.15)
    place = rig.body.com + rng.uniform(-0.03, 0.03, 3)
    lasting_s = rng.uniform(2.5, 5)
    y = 1 - np.exp(-np.maximum(rig.t - at_s, 0) / (lasting_s / 3))
    return Fault(
        family="payload_mass_change",
        variant="material runs out (or is filled in) once, over several seconds, exponential",
        size=lambda scale: {"t0": at_s, "dm": mass * scale, "at": place, "seconds": lasting_s},
        change_payload=lambda scale: _change_by_point(mass * scale * y, place),
        limits=(0.2, 2.5),
    )


def _change_by_point(mass: Array, place: Array) -> Change:
    """What point masses (N,) in kg at a place (3,), m, add."""
    return Change(mass, mass[:, None] * place, mass[:, None, None] * find_steiner(1.0, place))


def bend(rng: np.random.Generator, rig: Rig) -> Fault:
    """A slender tool: a share of the mass on three springs."""
    mass = rng.uniform(0.35, 0.6) * rig.body.mass
    natural_hz = np.sort(rng.uniform(11, 26, 3))
    natural_hz[2] *= 1.5
    damping = rng.uniform(0.006, 0.02, 3)
    R = rotate_by_vector(rng.normal(size=3))
    place = rig.body.com * 1.15

    def ring(k: Kinematics, scale: float) -> Array:
        u = k.u @ R
        felt, off = np.empty_like(u), np.empty_like(u)
        for i in range(3):
            w = 2 * np.pi * natural_hz[i] / np.sqrt(scale)
            b, a = signal.bilinear([2 * damping[i] * w, w * w], [1, 2 * damping[i] * w, w * w], fs=1 / STEP_S)
            felt[:, i] = filter_from_rest(b, a, u[:, i])
            off[:, i] = -felt[:, i] / (w * w)
        f, x = (mass * felt) @ R.T, off @ R.T
        more = f - mass * k.u
        return np.hstack([more, np.cross(place, more) + np.cross(x, f)])

    return Fault(
        family="tool_flexibility",
        variant="slender tool: part of the mass on three weakly damped modes, rings after jerky starts and stops, sags with gravity",
        size=lambda scale: {"mass": mass, "f_hz": natural_hz / np.sqrt(scale), "zeta": damping},
        add_wrench=ring,
        limits=(0.4, 3),
        wanted=(1.8, 8),
    )
