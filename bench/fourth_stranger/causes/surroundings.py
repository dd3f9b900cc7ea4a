"""Something besides gravity and motion acts on the payload: spiral hoses, chains, doors, corners to be caught on."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction, list_stretches
from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import push
from bench.second_stranger.signals import lag, rise


def _find_up(rig: Rig) -> Array:
    """(3,), of length 1, base axes."""
    return normalise(-rig.gravity)


def cable_spiral(_: np.random.Generator, rig: Rig) -> Fault:
    """A spiral hose that hangs from the ceiling: it hardly pulls until it is long, and then more and more."""
    at = 0.9 * rig.body.com
    places = rig.nominal.find_place(at)
    spread = float(np.linalg.norm(np.std(places, axis=0)))
    anchor = places.mean(0) + 1.8 * spread * _find_up(rig) + 0.6 * spread * np.array([0.4, -0.7, 0.1])
    ways = np.linalg.norm(anchor - places, axis=1)
    free, width = float(np.min(ways)), 0.5 * float(np.ptp(ways))

    def pull(W: Array, k: Kinematics, scale: float) -> Array:
        way = anchor - k.find_place(at)
        distance = np.linalg.norm(way, axis=1)
        force = 0.05 * scale * rig.body.mass * 9.8 * (np.exp((distance - free) / width) - 1) / (np.e**2 - 1)
        return push(W, k, force[:, None] * way / distance[:, None], at)

    return Fault(
        size=lambda scale: Size("spiral hose that stiffens, pulls at its longest with", 0.05 * scale * rig.body.mass * 9.8, "N"), touch=pull
    )


def cable_chain(_: np.random.Generator, rig: Rig) -> Fault:
    """An energy chain is drawn along one way of the hall: it rubs against its trough, and what is drawn out wants back."""
    at, along = rig.body.com * 1.1, normalise(np.cross(_find_up(rig), [0.6, 0.53, 0.6]))
    places = rig.nominal.find_place(at) @ along
    middle, span = float(np.median(places)), float(np.ptp(places))

    def drag(W: Array, k: Kinematics, scale: float) -> Array:
        x, v = k.find_place(at) @ along - middle, k.find_speed(at) @ along
        rubbing = lag(np.tanh(v / 0.015)[:, None], 0.05)[:, 0]
        force = -0.03 * scale * rig.body.mass * 9.8 * (0.7 * rubbing + 1.6 * x / span)
        return push(W, k, np.outer(force, along), at)

    return Fault(
        size=lambda scale: Size("energy chain rubs along one way (and wants back), with", 0.021 * scale * rig.body.mass * 9.8, "N"),
        touch=drag,
    )


def contact_door(rng: np.random.Generator, rig: Rig) -> Fault:
    """A pneumatic door shuts against the tool, three times: it strikes, gives, and leans with what the air does."""
    count, shape = 3, np.zeros(len(rig.t))
    lasting_s = min(3.2, 0.08 * rig.seconds)
    for share in (np.arange(count) + rng.uniform(0.25, 0.75, count)) / count:
        x = rig.t - share * rig.seconds * 0.92
        leans = 1 - 0.35 * np.exp(-np.maximum(x, 0) / 0.5) + 0.6 * np.exp(-np.maximum(x, 0) / 0.12)
        shape += rise(x / 0.05) * leans * (1 - rise((x - lasting_s) / 0.3))
    toward, at = draw_direction(rng), 1.4 * rig.body.com + 0.3 * np.linalg.norm(rig.body.com) * draw_direction(rng)
    amount = 0.3 * rig.body.mass * 9.8
    return Fault(
        size=lambda scale: Size(f"door leans against it {count} times for {lasting_s:.1f} s, force", amount * scale, "N"),
        touch=lambda W, k, scale: push(W, k, amount * scale * np.outer(shape, toward), at),
    )


def contact_snag(rng: np.random.Generator, rig: Rig) -> Fault:
    """The tool is caught on a corner on its way, pulls at it like at a spring, and tears itself off."""
    at = 1.3 * rig.body.com
    ways = list_stretches(rig, "transfer", 0.2, 0.85)
    count = min(2, len(ways))
    chosen = sorted(int(place) for place in rng.choice(len(ways), count, replace=False))
    places, force, held = rig.nominal.find_place(at), np.zeros((len(rig.t), 3)), 0.0
    for way in (ways[place] for place in chosen):
        begin_s = way.begin_s + 0.35 * (way.end_s - way.begin_s)
        until_s = way.end_s + rng.uniform(0.2, 0.6)
        caught = places[int(begin_s * 1000)]
        drawn = caught - places
        most = float(np.linalg.norm(drawn[int(way.end_s * 1000) - 1])) + 1e-6
        is_caught = rise((rig.t - begin_s) / 0.02) * (1 - rise((rig.t - until_s) / 0.025))
        force += is_caught[:, None] * drawn / most
        held += until_s - begin_s
    amount = 0.4 * rig.body.mass * 9.8
    return Fault(
        size=lambda scale: Size(f"caught {count} times, {held:.1f} s in all, tears off at", amount * scale, "N"),
        touch=lambda W, k, scale: push(W, k, amount * scale * force, at),
    )
