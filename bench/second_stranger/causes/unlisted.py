"""Causes that no diagnosis has a name for."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_offset, measure_force, normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import BaseTurn, Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import push
from bench.second_stranger.signals import derive, lag, rise


def u_gyro(_: np.random.Generator, rig: Rig) -> Fault:
    """A spindle in the tool."""
    axis, seconds = normalise([0.95, 0.2, 0.25]), rig.seconds
    up, slower = rise((rig.t - 0.1 * seconds) / (0.06 * seconds)), rise((rig.t - 0.5 * seconds) / (0.03 * seconds))
    spin = 0.05 * (up - 0.35 * slower - 0.65 * rise((rig.t - 0.86 * seconds) / (0.1 * seconds)))
    run_up = derive(spin)

    def turn(W: Array, k: Kinematics, scale: float) -> Array:
        W = W.copy()
        W[:, 3:] += scale * (np.outer(run_up, axis) + np.cross(k.omega, np.outer(spin, axis)))
        return W

    what = "spindle in the tool runs up, slows and stops: spin momentum"
    return Fault(size=lambda scale: Size(what, 0.05 * scale, "N m s"), touch=turn)


def u_air(_: np.random.Generator, rig: Rig) -> Fault:
    """A sheet in still air."""
    normal = normalise([0.8, 0.6, 0])
    first = normalise(np.cross(normal, [0, 0, 1]))
    second = np.cross(normal, first)
    patches = [0.15 * i * first + 0.15 * j * second + np.array([0, 0, 0.25]) for i in (-2, -1, 0, 1, 2) for j in (-1, 0, 1)]

    def drag(W: Array, k: Kinematics, scale: float) -> Array:
        force, torque = np.zeros((len(rig.t), 3)), np.zeros((len(rig.t), 3))
        speed = k.turn_into_sensor(k.v)
        for place in patches:
            through = (speed + np.cross(k.omega, place)) @ normal
            f = -np.outer(0.6 * 1.9 * 0.0225 * scale * through * np.abs(through), normal)
            force += f
            torque += np.cross(place, f)
        return W - np.hstack([force, torque])

    what = "air drag on a sheet, area (with honeycomb face Cd 1.9)"
    return Fault(size=lambda scale: Size(what, 0.34 * scale, "m2"), touch=drag)


def u_magnet(_: np.random.Generator, rig: Rig) -> Fault:
    """A permanent magnet in a field that differs from place to place."""
    moment, field = normalise([0.9, 0.3, -0.5]), normalise([0.8, 0.5, -0.2])

    def turn(W: Array, k: Kinematics, scale: float) -> Array:
        W = W.copy()
        felt = k.turn_into_sensor(np.tile(field, (len(rig.t), 1))) * (1 + 0.25 * np.tanh((k.p[:, :1] - 0.3) * 2))
        W[:, 3:] -= 0.1 * scale * np.cross(moment, felt)
        return W

    what = "permanent magnet in the tool in a stray field: torque"
    return Fault(size=lambda scale: Size(what, 0.1 * scale, "N m"), touch=turn)


def u_eddy(_: np.random.Generator, rig: Rig) -> Fault:
    """Magnets brake the payload where it comes near them."""
    at = rig.body.com + np.array([0.05, 0.03, 0.09])
    magnets = np.median(rig.nominal.p, axis=0)

    def brake(W: Array, k: Kinematics, scale: float) -> Array:
        squared = ((k.find_place(at) - magnets) ** 2).sum(1)
        per_speed = 8 * scale / (1 + squared / 0.2**2) ** 2
        return push(W, k, -per_speed[:, None] * k.find_speed(at), at)

    return Fault(size=lambda scale: Size("eddy-current brake near magnets: up to", 8 * scale, "N s/m"), touch=brake)


def u_ship(rng: np.random.Generator, rig: Rig) -> Fault:
    """A deck that heaves."""
    a = np.zeros((len(rig.t), 3))
    for i, amplitude in enumerate((0.12, 0.09, 0.25)):
        for hz in (0.11, 0.145, 0.19):
            share = amplitude * rng.uniform(0.4, 1)
            a[:, i] += share * np.sin(2 * np.pi * hz * rng.uniform(0.95, 1.05) * rig.t + rng.uniform(0, 6.3))
    what = "base on a heaving deck (translation), vertical acceleration amplitude about"
    return _shake(what, 0.25, a)


def u_track(rng: np.random.Generator, rig: Rig) -> Fault:
    """The whole arm is moved along a track."""
    a = np.zeros(len(rig.t))
    at_s, sign = 4.0, 1
    while at_s < rig.seconds - 6:
        for begin_s, way in ((at_s, 1), (at_s + 1.6, -1)):
            x = (rig.t - begin_s) / 0.7
            a += sign * way * np.where((x > 0) & (x < 1), np.sin(np.pi * np.clip(x, 0, 1)) ** 2, 0)
        at_s += rng.uniform(5, 9)
        sign = -sign
    what = "linear track under the base moves unrecorded, peak acceleration"
    return _shake(what, 1.0, np.outer(a, [0.9, 0.44, 0]))


def u_press(rng: np.random.Generator, rig: Rig) -> Fault:
    """A press beside the arm."""
    a = np.zeros((len(rig.t), 3))
    at_s = 1.5
    while at_s < rig.seconds:
        x = np.maximum(rig.t - at_s, 0)
        slow = np.exp(-x * 2 * np.pi * 5.2 * 0.06) * np.sin(2 * np.pi * 5.2 * x)
        fast = np.exp(-x * 2 * np.pi * 8.7 * 0.05) * np.sin(2 * np.pi * 8.7 * x)
        a += np.outer(slow, [0.7, 0.2, 0]) + np.outer(fast, [0, 0.1, 0.6])
        at_s += 3.1 + rng.normal() * 0.25
    return _shake("shocks of a press shake the base, ring 5.2 and 8.7 Hz, acceleration", 0.7, a)


def _shake(what: str, size: float, acceleration: Array) -> Fault:
    """The base, by an acceleration (N, 3), m/s^2, base axes, whose size is so much."""
    return Fault(
        size=lambda scale: Size(what, size * scale, "m/s2"),
        turn_gravity=lambda g, scale: g - scale * acceleration,
    )


def u_emi(rng: np.random.Generator, rig: Rig) -> Fault:
    """Currents of two drives show in the bridge."""
    dq = derive(rig.q)
    a, b = draw_offset(rng), draw_offset(rng)
    coupled = np.outer(lag(dq[:, 1:2], 0.01)[:, 0], a) + np.outer(np.abs(dq[:, 3]), b)
    what = "drive currents couple into the bridge: force offset per rad/s"
    return Fault(
        size=lambda scale: Size(what, scale * measure_force(a), "N s/rad"),
        distort=lambda W, scale: W + scale * coupled,
    )


def u_turntable(rng: np.random.Generator, rig: Rig) -> Fault:
    """The base stands on a table that turns."""
    angle = np.zeros(len(rig.t))
    at_s = 3.0
    while at_s < rig.seconds - 5:
        angle += rng.choice([-1, 1]) * 0.8 * rise((rig.t - at_s) / 2.2)
        at_s += rng.uniform(4.5, 7)
    rate = derive(angle)
    acceleration = derive(rate)
    what = "index table under the base turns unrecorded, step"
    return Fault(
        size=lambda scale: Size(what, np.degrees(0.8 * scale), "deg"),
        turn_base=lambda scale: BaseTurn(scale * angle, scale * rate, scale * acceleration),
    )


def u_gravcomp(_: np.random.Generator, rig: Rig) -> Fault:
    """The controller takes off the weight of a tool that is not there."""
    com = rig.body.com * 1.1 + np.array([0, 0.01, 0])

    def add(W: Array, scale: float) -> Array:
        g = rig.nominal.turn_into_sensor(rig.spread_gravity(len(rig.t)))
        return np.asarray(W + 0.3 * rig.body.mass * scale * np.hstack([g, np.cross(com, g)]))

    what = "controller subtracts a static tool load that is left switched on"
    return Fault(size=lambda scale: Size(what, 0.3 * rig.body.mass * scale, "kg"), distort=add)
