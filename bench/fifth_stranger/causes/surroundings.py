"""What pulls and touches the payload from outside: a dress pack, a hose that remembers, hands, a rail."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction, list_stretches
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import push
from bench.second_stranger.signals import lag, rise

SLACK = 0.35
"""Of the dress pack's ways, by how far it may be from its anchor before it pulls."""


def _draw_anchor(rng: np.random.Generator, rig: Rig) -> Array:
    """(3,), m, base axes: on the middle of where the sensor is, and aside of that by the span of its ways."""
    p = rig.nominal.p
    return np.asarray(p.mean(0) + 0.7 * float(np.linalg.norm(np.ptp(p, axis=0))) * draw_direction(rng))


def cable_pack(rng: np.random.Generator, rig: Rig) -> Fault:
    """A dress pack that is slack near its anchor, pulls beyond that, and rubs in its rings."""
    anchor, weight = _draw_anchor(rng, rig), rig.body.mass * 9.81
    point = 0.3 * rig.body.com
    away = np.linalg.norm(rig.nominal.find_place(point) - anchor, axis=1)
    low, span = float(np.min(away)), float(np.ptp(away))

    def pull(W: Array, k: Kinematics, scale: float) -> Array:
        to = anchor - k.find_place(point)
        length = np.linalg.norm(to, axis=1, keepdims=True)
        stretch = 0.03 * np.logaddexp(0, ((length - low) / span - SLACK) / 0.03)
        rub = np.tanh(k.find_speed(point) / 0.03)
        return push(W, k, scale * weight * (0.03 * stretch * to / length - 0.002 * rub), point)

    return Fault(size=lambda scale: Size("stiffness of the dress pack", scale * 0.03 * weight / span, "N/m"), touch=pull)


def cable_hose(rng: np.random.Generator, rig: Rig) -> Fault:
    """A rubber hose pulls towards where it hangs from, and follows with a third of that only after seconds."""
    anchor, weight = _draw_anchor(rng, rig), rig.body.mass * 9.81
    span = float(np.linalg.norm(np.ptp(rig.nominal.p, axis=0)))
    point = 0.5 * rig.body.com

    def pull(W: Array, k: Kinematics, scale: float) -> Array:
        to = (anchor - k.find_place(point)) / span
        return push(W, k, 0.03 * scale * weight * (0.67 * to + 0.33 * lag(to, 2.5)), point)

    return Fault(size=lambda scale: Size("stiffness of the hose", 0.03 * scale * weight / span, "N/m"), touch=pull)


def contact_hands(rng: np.random.Generator, rig: Rig) -> Fault:
    """Somebody steadies the tool by hand three times, each time elsewhere, with a tremble and a sway."""
    force, point = np.zeros((len(rig.t), 3)), rig.body.com + 0.5 * float(np.linalg.norm(rig.body.com)) * draw_direction(rng)
    for middle in (0.22, 0.5, 0.8):
        begin, length = (middle + rng.uniform(-0.06, 0.06)) * rig.seconds, rng.uniform(1.5, 3.5)
        window = rise((rig.t - begin) / 0.4) * rise((begin + length - rig.t) / 0.5)
        sway = 1 + 0.35 * np.sin(2 * np.pi * rng.uniform(0.5, 0.9) * rig.t + 1) + 0.08 * np.sin(2 * np.pi * 7.7 * rig.t)
        force += np.outer(window * sway, rng.uniform(0.6, 1.2) * draw_direction(rng))
    weight = 0.1 * rig.body.mass * 9.81
    return Fault(
        size=lambda scale: Size("force of the hands, about", weight * scale, "N"),
        touch=lambda W, k, scale: push(W, k, scale * weight * force, point),
    )


def contact_rail(rng: np.random.Generator, rig: Rig) -> Fault:
    """The tool comes to lie on a rail at two of its stops, and rubs along it as it leaves."""
    stops = list_stretches(rig, "hold", 0.2, 0.85)
    chosen = sorted(rng.permutation(len(stops))[:2].tolist())
    point, weight = 1.4 * rig.body.com, 0.08 * rig.body.mass * 9.81
    force = np.zeros((len(rig.t), 3))
    for place in chosen:
        stop = stops[place]
        normal, along = draw_direction(rng), draw_direction(rng)
        window = rise((rig.t - stop.begin_s + 0.15) / 0.2) * rise((stop.end_s + 0.3 - rig.t) / 0.2)
        force += np.outer(window, normal) + 0.3 * np.outer(window * rise((rig.t - stop.end_s + 0.05) / 0.1), along)
    return Fault(
        size=lambda scale: Size("force of the rail", weight * scale, "N"),
        touch=lambda W, k, scale: push(W, k, scale * weight * force, point),
    )
