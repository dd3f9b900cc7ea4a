"""The payload is not one rigid body all the time: what trickles, dangles, slips, is dispensed or picked, and a nozzle that twists."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_moved_part_wrench, find_point_wrench, push
from bench.second_stranger.signals import STEP_S, lag, resonate, rise
from bench.third_stranger.draws import draw_moment, list_pauses

EVERY = 10
"""Steps of the grid."""
REPOSE, SETTLED = np.radians(34), np.radians(22)
"""Slopes at which a heap begins to slide and at which it lies again, rad."""
STRING_RATE, STRING_DAMPING, AIR_RATE = 75.0, 30.0, 0.3
"""rad/s, 1/s and 1/s: how stiff the string of a pendulum is, how it is damped, and how the air slows what hangs on it."""


def loose_granulate(_: np.random.Generator, rig: Rig) -> Fault:
    """Granulate in a hopper lies until it is tilted too far, and slides down to a flatter slope."""
    mass, rest = 0.28 * rig.body.mass, rig.body.com + np.array([0.01, 0, 0.02])
    low = -rig.nominal.u[::EVERY] / np.linalg.norm(rig.nominal.u[::EVERY], axis=1, keepdims=True)
    heap = np.stack([np.interp(rig.t, rig.t[::EVERY], column) for column in _slide_down(low).T], 1)
    by = lag(lag(heap, 0.06), 0.06) * np.array([1, 0.8, 0.5])
    by = by - by[0]
    return Fault(
        size=lambda scale: Size("granulate, 28 % of the mass, its centre's half way in the hopper", 18 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rest, 0.018 * scale * by),
    )


def _slide_down(low: Array) -> Array:
    """(N, 3), where a heap lies while the lowest direction is (N, 3): behind it by no more than its slope of repose."""
    lies, is_sliding = low[0], False
    heap = np.empty_like(low)
    for i, down in enumerate(low):
        off = float(np.arccos(np.clip(lies @ down, -1, 1)))
        is_sliding = off > (SETTLED if is_sliding else REPOSE)
        if is_sliding:
            lies = lies + min(1.0, EVERY * STEP_S / 0.2) * (down - lies)
            lies = lies / np.linalg.norm(lies)
        heap[i] = lies
    return heap


def loose_pendulum(_: np.random.Generator, rig: Rig) -> Fault:
    """A plug dangles on a lead; while it hangs still it is part of what the file says of the payload."""
    at, length = rig.body.com + np.array([0.03, 0.05, 0.04]), 0.16
    tension = _dangle(rig.nominal.find_place(at), rig.tilted_gravity, length)

    def dangle(W: Array, k: Kinematics, scale: float) -> Array:
        mass = 0.12 * rig.body.mass * scale
        return push(W, k, mass * tension, at) - mass * find_point_wrench(k, at)

    return Fault(
        size=lambda scale: Size("plug on a lead of 16 cm swings freely (1.2 Hz), mass", 0.12 * rig.body.mass * scale, "kg"),
        change_payload=dangle,
    )


def _dangle(places: Array, gravity: Array, length: float) -> Array:
    """(N, 3), N for each kg: how what hangs on a string pulls at places (N, 3), m; gravity (N, 3), m/s^2; base axes."""
    x = places[0] + gravity[0] / np.linalg.norm(gravity[0]) * (length + np.linalg.norm(gravity[0]) / STRING_RATE**2)
    v, speeds = np.zeros(3), np.diff(places, axis=0, append=places[-1:]) / STEP_S
    pulls = np.empty_like(places)
    for i, (place, speed, g) in enumerate(zip(places, speeds, gravity, strict=True)):
        way = x - place
        distance = float(np.sqrt(way @ way))
        along = way / distance
        pull = max(0.0, STRING_RATE**2 * (distance - length) + STRING_DAMPING * float((v - speed) @ along))
        pulls[i] = pull * along
        v = v + STEP_S * (g - pulls[i] - AIR_RATE * v)
        x = x + STEP_S * v
    return pulls


def shift_vacuum(rng: np.random.Generator, rig: Rig) -> Fault:
    """A sheet slips on its suction cups in a quick move, and creeps on for a while."""
    at_s = draw_moment(rng, rig, 0.35, 0.65, "transfer")
    mass, rest = 0.3 * rig.body.mass, rig.body.com + np.array([0.02, -0.03, 0.03])
    angle, since = rng.uniform(0, 2 * np.pi), rig.t - at_s
    d = np.array([np.cos(angle), np.sin(angle), 0])
    shape = 0.7 * rise(since / 0.25) + 0.3 * rise(since / 2) * (1 - np.exp(-np.maximum(since, 0) / 4))
    return Fault(
        size=lambda scale: Size(f"30 % of the mass slips at {at_s:.1f} s on suction cups and creeps on, by", 12 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rest, 0.012 * scale * np.outer(shape, d)),
    )


def shift_regrip(rng: np.random.Generator, rig: Rig) -> Fault:
    """The part is put down and gripped elsewhere while the recorder pauses."""
    at_s, d = list_pauses(rig)[0], normalise(rng.normal(size=3))
    mass, rest = 0.4 * rig.body.mass, rig.body.com + np.array([0, 0.02, 0.04])
    shape = rise((rig.t - at_s + 0.3) / 0.6)
    return Fault(
        size=lambda scale: Size(f"40 % of the mass gripped elsewhere in a pause at {at_s:.1f} s, by", 8 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rest, 0.008 * scale * np.outer(shape, d)),
        at_s=at_s,
    )


def mass_dispense(rng: np.random.Generator, rig: Rig) -> Fault:
    """Glue is dispensed along one seam, evenly."""
    at_s, lasting_s = rng.uniform(0.35, 0.5) * rig.seconds, rng.uniform(7, 11)
    at, shape = rig.body.com + np.array([-0.02, 0.01, -0.03]), np.clip((rig.t - at_s) / lasting_s, 0, 1)
    return Fault(
        size=lambda scale: Size(f"dispensed evenly from {at_s:.1f} s on for {lasting_s:.1f} s", -100 * scale, "g"),
        change_payload=lambda W, k, scale: W - 0.1 * scale * shape[:, None] * find_point_wrench(k, at),
    )


def mass_pick(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part is picked at a stop."""
    at_s = draw_moment(rng, rig, 0.25, 0.5, "hold")
    at, shape = rig.body.com + np.array([0.01, 0.02, 0.07]), rise((rig.t - at_s) / 0.3)
    return Fault(
        size=lambda scale: Size(f"picked at {at_s:.1f} s", 100 * scale, "g"),
        change_payload=lambda W, k, scale: W + 0.1 * scale * shape[:, None] * find_point_wrench(k, at),
        at_s=at_s,
    )


def flex_torsion(_: np.random.Generator, rig: Rig) -> Fault:
    """A bent nozzle twists about the tool's axis, and nods less and faster."""
    mass, arm = 0.16 * rig.body.mass, np.array([0.17, 0.0, 0.02])
    rest = rig.body.com + arm
    sideways, nodding = np.array([0.0, 1.0, 0.0]), np.array([-0.12, 0.0, 1.0])
    modes = ((sideways, 11.3, 0.009), (normalise(nodding), 23.0, 0.02))

    def twist(W: Array, k: Kinematics, scale: float) -> Array:
        pull = -k.feel_at(rest)
        by = np.zeros((len(rig.t), 3))
        for direction, hz, damping in modes:
            x = resonate((pull @ direction)[:, None], hz, damping)[:, 0] / (2 * np.pi * hz) ** 2
            by += np.outer(x - x[0], direction)
        return W + find_moved_part_wrench(k, mass * scale, rest, by)

    return Fault(
        size=lambda scale: Size("nozzle twists about the tool at 11.3 Hz (nods at 23 Hz), mass that swings", mass * scale, "kg"),
        change_payload=twist,
    )
