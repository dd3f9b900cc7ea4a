"""The payload is not rigid or not the same throughout: flaps, bags, slips, chips, something hung on it, a whip."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction
from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_time
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_moved_part_wrench, find_point_wrench
from bench.second_stranger.signals import resonate, rise

PART, FLAP_STOP_M = 0.2, 0.012
"""Share of the payload's mass that moves; and how far a flap does, m."""


def _hang(k: Kinematics, at: Array, hz: float, damping: float) -> Array:
    """(N, 3), m, sensor axes: how far a part at a place (3,), m, on springs is out."""
    return np.asarray(-resonate(k.feel_at(at), hz, damping) / (2 * np.pi * hz) ** 2)


def loose_flap(rng: np.random.Generator, rig: Rig) -> Fault:
    """A flap on a weak spring swings along one line and meets rubber at both ends; its mass is scaled."""
    along, at, mass = draw_direction(rng), 1.3 * rig.body.com, PART * rig.body.mass

    def swing(W: Array, k: Kinematics, scale: float) -> Array:
        out = _hang(k, at, 2.6, 0.25) @ along
        by = np.outer(FLAP_STOP_M * np.tanh(out / FLAP_STOP_M), along)
        return W + scale * find_moved_part_wrench(k, mass, at, by)

    return Fault(size=lambda scale: Size("mass of a flap that swings by 12 mm", scale * mass, "kg"), change_payload=swing)


def loose_bag(rng: np.random.Generator, rig: Rig) -> Fault:
    """A bag of powder sags to where down is, slowly and damped, more along one axis than along the others."""
    at, mass = 1.1 * rig.body.com, PART * rig.body.mass
    hz = (3.0 * rng.uniform(0.85, 1.2, 3)).tolist()

    def sag(W: Array, k: Kinematics, scale: float) -> Array:
        by = np.stack([_hang(k, at, f, 0.7)[:, i] for i, f in enumerate(hz)], 1)
        return W + scale * find_moved_part_wrench(k, mass, at, by)

    return Fault(size=lambda scale: Size("mass of a bag that sags by some 28 mm", scale * mass, "kg"), change_payload=sag)


def _slip(rig: Rig, begin_s: float, seconds: float, by: Array, what: str) -> Fault:
    """A third of the payload goes by (3,), m, from a time on, within so many s."""
    mass, path = rig.body.mass / 3, np.outer(rise((rig.t - begin_s) / seconds), by)
    return Fault(
        size=lambda scale: Size(what, 1e3 * scale * float(np.linalg.norm(by)), "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rig.body.com, scale * path),
    )


def shift_slide(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part creeps out of its jaws within two seconds, until it meets their end."""
    return _slip(rig, draw_time(rng, rig, 0.3, 0.65), 2.2, 0.01 * draw_direction(rng), "a third of the payload slides")


def shift_snap(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part jumps out of its detent in motion and lies one further."""
    return _slip(rig, draw_time(rng, rig, 0.35, 0.7, "transfer"), 0.12, 0.01 * draw_direction(rng), "a third of the payload jumps")


def _change_mass(rig: Rig, at: Array, share: Array, what: str) -> Fault:
    """By 4 % of the payload's mass times a share (N,), at a place (3,), m."""
    mass = 0.04 * rig.body.mass
    sign = float(np.sign(share[-1]))
    return Fault(
        size=lambda scale: Size(what, 1e3 * sign * scale * mass, "g"),
        change_payload=lambda W, k, scale: W + scale * mass * share[:, None] * find_point_wrench(k, at),
    )


def mass_sprue(rng: np.random.Generator, rig: Rig) -> Fault:
    """The sprue breaks off the casting at its far end, hangs by a burr for a moment, and falls."""
    at = 1.6 * rig.body.com + 0.3 * float(np.linalg.norm(rig.body.com)) * draw_direction(rng)
    return _change_mass(rig, at, -rise((rig.t - draw_time(rng, rig, 0.3, 0.7)) / 0.1), "a sprue breaks off")


def mass_bucket(rng: np.random.Generator, rig: Rig) -> Fault:
    """A ladle is filled within five seconds, faster at first."""
    since = np.maximum(rig.t - draw_time(rng, rig, 0.25, 0.6), 0)
    filled = np.clip(1 - np.clip(1 - since / 5, 0, 1) ** 1.5, 0, 1)
    return _change_mass(rig, 1.2 * rig.body.com, filled, "a ladle is filled")


def flex_whip(rng: np.random.Generator, _: Rig) -> Fault:
    """A long tool whips across its axis, in two planes not quite alike; the share of it that does is scaled."""
    hz = 14 * rng.uniform(0.9, 1.2)

    def whip(W: Array, __: Kinematics, scale: float) -> Array:
        rung = W.copy()
        for channels, f in (([0, 4], hz), ([1, 3], 1.12 * hz)):
            part = W[:, channels]
            rung[:, channels] += 0.4 * scale * (resonate(part, f, 0.025) - part)
        return rung

    return Fault(size=lambda scale: Size(f"share of the tool that whips at {hz:.1f} Hz and above", 0.4 * scale, "-"), change_payload=whip)
