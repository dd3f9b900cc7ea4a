"""Something besides gravity and motion acts on the payload: balancers, hoses on the floor, fixtures, people."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import push
from bench.second_stranger.signals import derive, lag, rise

SAME_RAD = 0.02
"""Within which two stops are the same place."""


def cable_balancer(_: np.random.Generator, rig: Rig) -> Fault:
    """A balancer overhead pulls up its line with a spring that is nearly of one force, and less while it reels in."""
    anchor, at = np.array([0.5, -0.3, 2.1]), rig.body.com + np.array([0.02, -0.04, 0.05])

    def pull(W: Array, k: Kinematics, scale: float) -> Array:
        way = anchor - k.find_place(at)
        distance = np.linalg.norm(way, axis=1)
        losing = 1 + 0.12 * np.tanh(derive(distance) / 0.03)
        force = 2.5 * scale * (1 + 0.35 * (distance - distance.mean())) * losing
        return push(W, k, force[:, None] * way / distance[:, None], at)

    return Fault(size=lambda scale: Size("balancer with a line from above, pulls with about", 2.5 * scale, "N"), touch=pull)


def cable_floor(_: np.random.Generator, rig: Rig) -> Fault:
    """A hose that lies on the floor: what is lifted weighs, and what lies there is dragged."""
    at = rig.body.com + np.array([-0.03, 0.03, 0.02])
    lowest = rig.nominal.find_place(at)[:, 2].min() - 0.1

    def drag(W: Array, k: Kinematics, scale: float) -> Array:
        v, height = k.find_speed(at), k.find_place(at)[:, 2] - lowest
        across = v * np.array([1, 1, 0.2])
        rubbing = lag(-across / (np.linalg.norm(across, axis=1, keepdims=True) + 0.03), 0.08)
        weight = np.outer(-2.6 * height * (1 + 0.2 * height), [0, 0, 1])
        return push(W, k, scale * (weight + 0.5 * rubbing), at)

    return Fault(
        size=lambda scale: Size("hose from the floor, weight of what is lifted (dragged with a fifth of it)", 2.6 * scale, "N/m"),
        touch=drag,
    )


def contact_fixture(_: np.random.Generator, rig: Rig) -> Fault:
    """The tool is set down a little too low in a fixture, each time the arm comes by."""
    at, force = rig.body.com + np.array([0.02, 0.01, 0.08]), np.zeros((len(rig.t), 3))
    visits = _find_visits(rig)
    for place, (begin_s, end_s) in enumerate(visits):
        x = rig.t - begin_s
        shape = rise((x + 0.12) / 0.2) * (1 - rise((rig.t - end_s + 0.05) / 0.15)) * (1 - 0.15 * (1 - np.exp(-np.maximum(x, 0) / 0.5)))
        force += (1 + 0.08 * np.sin(2.4 * place)) * np.outer(shape, [0.15, -0.2, 1.0])
    return Fault(
        size=lambda scale: Size(f"set down too hard in a fixture {len(visits)} times, force", 5 * scale, "N"),
        touch=lambda W, k, scale: push(W, k, 5 * scale * force, at),
    )


def _find_visits(rig: Rig) -> list[tuple[float, float]]:
    """Begin and end, s, of the stops at the place where the arm stops most often, but for the first of all."""
    stops = [each for each in rig.stretches if each.label.startswith("hold")][1:]
    where = np.array([each.follow(np.array([each.begin_s]))[0] for each in stops])
    alike = np.abs(where[:, None] - where[None]).max(2) < SAME_RAD
    most = int(np.argmax(alike.sum(1)))
    visits: list[tuple[float, float]] = []
    for stop, is_there in zip(stops, alike[most], strict=True):
        if is_there and visits and visits[-1][1] == stop.begin_s:
            visits[-1] = visits[-1][0], stop.end_s
        elif is_there:
            visits.append((stop.begin_s, stop.end_s))
    return visits


def contact_lean(rng: np.random.Generator, rig: Rig) -> Fault:
    """Somebody hangs on the tool for a long while, more and more, and sways."""
    begin_s, lasting_s = rng.uniform(0.3, 0.45) * rig.seconds, rng.uniform(9, 14)
    at, toward, x = rig.body.com + np.array([0.04, 0.03, 0.06]), normalise(rng.normal(size=3)), rig.t - begin_s
    across = normalise(np.cross(toward, rng.normal(size=3)))
    held = rise(x / 1.2) * (1 - rise((x - lasting_s) / 0.8)) * (0.7 + 0.3 * np.clip(x / lasting_s, 0, 1))
    sway = 0.25 * np.sin(2 * np.pi * 0.31 * x) + 0.1 * np.sin(2 * np.pi * 0.83 * x + 1)
    force = held[:, None] * (toward + np.outer(sway, across))
    return Fault(
        size=lambda scale: Size(f"somebody leans on it for {lasting_s:.0f} s from {begin_s:.0f} s, force", 4 * scale, "N"),
        touch=lambda W, k, scale: push(W, k, 4 * scale * force, at),
    )


def contact_nudges(rng: np.random.Generator, rig: Rig) -> Fault:
    """Nudges of many sizes in passing, at different points of the tool."""
    count = int(rng.integers(6, 10))
    nudges = []
    for begin_s in np.sort(rng.uniform(0.08, 0.92, count)) * rig.seconds:
        x, up_s, down_s = rig.t - begin_s, rng.uniform(0.08, 0.2), rng.uniform(0.2, 0.7)
        shape = rise(x / up_s) * np.exp(-np.maximum(x - up_s, 0) / down_s) * (1 - rise((x - 4 * down_s) / down_s))
        amount = np.exp(0.5 * rng.normal())
        nudges.append((amount * np.outer(shape, normalise(rng.normal(size=3))), rig.body.com + rng.uniform(-0.06, 0.08, 3)))

    def nudge(W: Array, k: Kinematics, scale: float) -> Array:
        for force, at in nudges:
            W = push(W, k, 6 * scale * force, at)
        return W

    return Fault(size=lambda scale: Size(f"{count} nudges of many sizes at many points, force about", 6 * scale, "N"), touch=nudge)
