"""The payload is not one rigid body for all of the time: parts that are loose, slip, fall off or are filled in, and tools that bend."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_time, normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_moved_part_wrench, find_point_wrench
from bench.second_stranger.signals import STEP_S, lag, resonate, rise


def loose_rubber(_: np.random.Generator, rig: Rig) -> Fault:
    """A part on rubber with stops."""
    mass, rest = 0.22 * rig.body.mass, rig.body.com + np.array([0.02, 0.03, 0.03])
    hz, damping, stop = np.array([3.2, 4.1, 6.0]), (0.06, 0.09, 0.1), 0.03

    def swing(W: Array, k: Kinematics, scale: float) -> Array:
        f = hz / np.sqrt(scale)
        pull = -k.feel_at(rest)
        x = [resonate(pull[:, i : i + 1], f[i], damping[i])[:, 0] / (2 * np.pi * f[i]) ** 2 for i in range(3)]
        return W + find_moved_part_wrench(k, mass, rest, stop * np.tanh(np.stack(x, 1) / stop))

    what = "22 % of the mass on rubber with bump stops, lowest frequency"
    return Fault(size=lambda scale: Size(what, 3.2 / np.sqrt(scale), "Hz"), change_payload=swing)


def loose_slosh(_: np.random.Generator, rig: Rig) -> Fault:
    """A liquid in a long tank."""
    mass, rest = 0.3 * rig.body.mass, rig.body.com + np.array([0, 0, 0.02])

    def slosh(W: Array, k: Kinematics, scale: float) -> Array:
        low = -k.u / np.linalg.norm(k.u, axis=1, keepdims=True)
        x = 0.02 * scale * resonate(resonate(low, 1.7, 0.12), 7.0, 0.7)
        return W + find_moved_part_wrench(k, mass, rest, x * np.array([1, 0.3, 0.6]))

    what = "liquid (30 % of mass), long tank, its centre swings at 1.7 Hz within half axis"
    return Fault(size=lambda scale: Size(what, 20 * scale, "mm"), change_payload=slosh)


def loose_sleeve(_: np.random.Generator, rig: Rig) -> Fault:
    """A sleeve on a rod between two stops, with dry friction."""
    mass, rest = 0.12 * rig.body.mass, rig.body.com + np.array([0.03, -0.02, 0.02])
    axis = normalise([1, 0.25, 0.1])
    felt = rig.nominal.feel_at(rest)
    across = np.linalg.norm(felt - np.outer(felt @ axis, axis), axis=1)
    x = _slide(-(felt @ axis), across)
    x = lag(lag(x[:, None], 0.012), 0.012)[:, 0]
    by = np.outer(x - x[0], axis)
    return Fault(
        size=lambda scale: Size("sleeve on a rod, dry friction 0.25, stops +-20 mm, mass", mass * scale, "kg"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass * scale, rest, by),
    )


def _slide(along: Array, across: Array) -> Array:
    """(N,), m, where a sleeve is that is pulled along its rod by (N,) and pressed on it by (N,), m/s^2; it begins at the lower stop."""
    stop, friction, spring, damper = 0.02, 0.25, 4e3, 60.0
    x = np.zeros(len(along))
    place, speed = -stop, 0.0
    for i, (pull, press) in enumerate(zip(along.tolist(), across.tolist(), strict=True)):
        a = pull
        if place > stop:
            a -= spring * (place - stop) + damper * speed
        elif place < -stop:
            a -= spring * (place + stop) + damper * speed
        free, held = speed + STEP_S * a, STEP_S * (friction * press)
        speed = 0.0 if abs(free) <= held else free - held * (1 if free > 0 else -1)
        place += STEP_S * speed
        x[i] = place
    return x


def shift_slide(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part slides, in two goes."""
    at_s = draw_time(rng, rig, 0.35, 0.65, "rotate")
    mass, rest = 0.15 * rig.body.mass, rig.body.com + 0.03 * normalise(rng.normal(size=3))
    d, since = normalise(rng.normal(size=3)), rig.t - at_s
    shape = 0.6 * rise(since / 0.45) + 0.4 * rise((since - 0.5) / 0.35)
    return Fault(
        size=lambda scale: Size(f"part of 15 % slides in 0.85 s at {at_s:.1f} s by", 20 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rest, 0.02 * scale * np.outer(shape, d)),
    )


def shift_by_contact(_: np.random.Generator, rig: Rig, contact_s: float) -> Fault:
    """A push that begins at a time, s, moves a part."""
    mass, rest = 0.25 * rig.body.mass, rig.body.com + np.array([0.02, 0, 0.03])
    d, shape = normalise([0.7, -0.5, 0.4]), rise((rig.t - contact_s - 0.5) / 0.4)
    return Fault(
        size=lambda scale: Size("part of 25 % displaced by the push, by", 15 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rest, 0.015 * scale * np.outer(shape, d)),
    )


def mass_drop(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part falls off, and the arm recoils."""
    at_s = draw_time(rng, rig, 0.35, 0.65)
    since = np.maximum(rig.t - at_s, 0)
    fallen = 1 - np.exp(-since / 0.02) * np.cos(2 * np.pi * 12 * since)
    shape = np.where(rig.t - at_s > 0, fallen, 0) * -1
    what = f"part falls off at {at_s:.1f} s with recoil"
    return _change_mass(rig, np.array([0.03, 0.02, 0.04]), shape, lambda scale: Size(what, -100 * scale, "g"))


def mass_fill(rng: np.random.Generator, rig: Rig) -> Fault:
    """Something is filled in."""
    at_s = draw_time(rng, rig, 0.3, 0.6)
    what = f"filled within 3.5 s from {at_s:.1f} s"
    shape = rise((rig.t - at_s) / 3.5)
    return _change_mass(rig, np.array([0.01, -0.02, 0.05]), shape, lambda scale: Size(what, 100 * scale, "g"))


def _change_mass(rig: Rig, beside: Array, shape: Array, size: Callable[[float], Size]) -> Fault:
    """By a tenth of a kilogram times a shape (N,), at a place (3,), m, beside the centre of mass."""
    at = rig.body.com + beside
    return Fault(
        size=size,
        change_payload=lambda W, k, scale: W + 0.1 * scale * (shape[:, None] * find_point_wrench(k, at)),
    )


def flex_modes(_: np.random.Generator, rig: Rig) -> Fault:
    """A tool that bends in two directions, and whose clamp slips."""
    mass, rest = 0.4 * rig.body.mass, rig.body.com * 1.2 + np.array([0, 0, 0.02])

    def bend(W: Array, k: Kinematics, scale: float) -> Array:
        pull = -k.feel_at(rest)
        x = np.zeros((len(pull), 3))
        for i, hz in enumerate((12.5, 17.5)):
            x[:, i] = _bend(pull[:, i], hz)
        return W + find_moved_part_wrench(k, mass * scale, rest, x)

    what = "two bending modes 12.5/17.5 Hz, damping grows with amplitude, modal mass"
    return Fault(size=lambda scale: Size(what, mass * scale, "kg"), change_payload=bend)


def _bend(pull: Array, hz: float) -> Array:
    """(N,), m, of a mode that is pulled by (N,), m/s^2, and damped more the farther it swings; semi-implicit."""
    w, h = 2 * np.pi * hz, STEP_S / 2
    values = pull.tolist()
    x, v, bent = values[0] / w**2, 0.0, np.empty(len(values))
    for i, value in enumerate(values):
        for _ in range(2):
            damping = 0.006 + 6.0 * abs(x - value / w**2)
            v += h * (value - w * w * x - 2 * damping * w * v)
            x += h * v
        bent[i] = x
    return bent
