"""Causes in the tool that no diagnosis has a name for."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_moved_part_wrench
from bench.second_stranger.rotations import find_cross_matrix
from bench.second_stranger.signals import STEP_S, lag, rise

SLIPS_AT = 0.7
"""Share of the usual angular acceleration above which a roller's bearing slips."""


def u_jet(_: np.random.Generator, rig: Rig) -> Fault:
    """A spray gun gives the more the faster it goes along, and kicks back; its axis is the tool's own."""
    axis, at = normalise([0.5, 0.35, 0.8]), 1.5 * rig.body.com + np.array([0.01, 0, 0])
    usual = float(np.quantile(np.linalg.norm(rig.nominal.find_speed(at), axis=1), 0.9))

    def kick(W: Array, k: Kinematics, scale: float) -> Array:
        speed = np.linalg.norm(k.find_speed(at), axis=1) / usual
        flow = lag((speed**2)[:, None], 0.04)
        force = 0.05 * scale * rig.body.mass * 9.8 * flow * axis
        return np.asarray(W + np.hstack([force, np.cross(at, force)]))

    return Fault(
        size=lambda scale: Size("spray gun kicks back by the square of its speed, at a usual one", 0.05 * scale * rig.body.mass * 9.8, "N"),
        touch=kick,
    )


def u_freewheel(_: np.random.Generator, rig: Rig) -> Fault:
    """A balanced roller in the tool turns in a bearing with dry friction: it stays behind when the tool turns quickly, and spins on."""
    n = normalise([0.35, 0.25, 0.9])
    turns = (rig.nominal.alpha @ n).tolist()
    most = SLIPS_AT * float(np.std(turns))
    s, given, spin = 0.0, np.empty(len(turns)), np.empty(len(turns))
    for i, a in enumerate(turns):
        if s == 0.0 and abs(a) <= most:
            given[i], spin[i] = a, 0.0
            continue
        drive = -most if s > 0 or (s == 0.0 and a < 0) else most
        after = s + STEP_S * (drive - a)
        s = 0.0 if s * after < 0 else after
        given[i], spin[i] = drive, s
    inertia = 0.4 * float(n @ rig.body.inertia_at_com @ n)

    def spare(W: Array, k: Kinematics, scale: float) -> Array:
        missing = (given - k.alpha @ n)[:, None] * n
        turned = np.cross(k.omega, spin[:, None] * n)
        changed = W.copy()
        changed[:, 3:] += scale * inertia * (missing + turned)
        return changed

    return Fault(size=lambda scale: Size("roller on a dry bearing, inertia", inertia * scale, "kg m^2"), change_payload=spare)


def u_turret(rng: np.random.Generator, rig: Rig) -> Fault:
    """A turret in the tool goes on by a sixth of a turn, now and then, and nobody records it."""
    n, out = normalise([0.2, 0.5, 0.8]), max(float(np.linalg.norm(rig.body.com)), 0.03)
    times = (np.arange(8) + rng.uniform(0.2, 0.8, 8)) / 8.5 * rig.seconds
    angle = np.pi / 3 * np.sum([rise((rig.t - each) / 0.5) for each in times], axis=0)
    first = 0.8 * out * normalise(np.cross(n, [1, 0.1, 0]))
    S = find_cross_matrix(n)
    by = np.outer(np.sin(angle), S @ first) + np.outer(1 - np.cos(angle), S @ S @ first)
    mass, rest = 0.05 * rig.body.mass, rig.body.com + first
    return Fault(
        size=lambda scale: Size("turret with one heavy tool of six goes on eight times, its mass", mass * scale, "kg"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass * scale, rest, by),
    )
