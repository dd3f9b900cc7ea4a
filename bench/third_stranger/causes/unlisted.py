"""Causes in the payload, the sensor and the clock that no diagnosis has a name for."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline

from bench.second_stranger.array import Array
from bench.second_stranger.draws import draw_offset, measure_force, normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import JointMotion, Kinematics, move_arm
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_body_wrench
from bench.second_stranger.signals import STEP_S

SUNS = 40
"""Places of the sun and the window that are tried, for one that is lit about half of the time."""


def u_unbalance(rng: np.random.Generator, rig: Rig) -> Fault:
    """A spindle that is out of balance speeds up and slows down: a force that turns with it and grows with its square."""
    axis = normalise([0.3, -0.2, 1])
    first = normalise(np.cross(axis, [1, 0.2, 0]))
    second = np.cross(axis, first)
    knots_s = np.linspace(0, rig.seconds, 9)
    speeds = np.array([0, 3.1, 5.2, 8.3, 6.4, 4.0, 7.3, 2.5, 0]) * rng.uniform(0.9, 1.1, 9)
    hz = np.interp(rig.t, knots_s, speeds)
    angle = 2 * np.pi * np.cumsum(hz) * STEP_S
    force = (hz[:, None] / 6) ** 2 * (np.outer(np.cos(angle), first) + np.outer(np.sin(angle), second))
    at = rig.body.com + np.array([0, 0, 0.06])
    both = np.hstack([force, np.cross(at, force)])
    return Fault(
        size=lambda scale: Size("spindle out of balance, between 0 and 8 Hz, force at 6 Hz", 2 * scale, "N"),
        touch=lambda W, _, scale: W + 2 * scale * both,
    )


def u_coriolis(_: np.random.Generator, rig: Rig) -> Fault:
    """Water streams through a lance, which has to be turned against it."""
    along, length = normalise([0.55, 0.35, 0.75]), 0.7
    stream = 1 + 0.08 * np.sin(2 * np.pi * rig.t / 7.3)

    def turn(W: Array, k: Kinematics, scale: float) -> Array:
        across = 0.8 * scale * stream[:, None] * np.cross(k.omega, along)
        return W + np.hstack([2 * length * across, length**2 * np.cross(along, across)])

    return Fault(size=lambda scale: Size("water through a lance of 70 cm, Coriolis force of a stream of", 0.8 * scale, "kg/s"), touch=turn)


def u_slow_clock(_: np.random.Generator, rig: Rig) -> Fault:
    """The recorder's second is not a second: all is faster or slower than it says."""
    path = CubicSpline(rig.t, rig.links)

    def hurry(W: Array, k: Kinematics, scale: float) -> Array:
        e = 0.03 * scale
        joints = JointMotion(rig.links, path(rig.t, 1) * (1 + e), path(rig.t, 2) * (1 + e) ** 2)
        hurried = move_arm(rig.arm, joints, rig.tilted_gravity)
        return np.asarray(W + find_body_wrench(hurried, rig.body) - find_body_wrench(k, rig.body))

    return Fault(size=lambda scale: Size("clock of the recorder is slow by", 3 * scale, "%"), change_payload=hurry)


def u_sunlight(rng: np.random.Generator, rig: Rig) -> Fault:
    """An optical sensor reads the sun where its window looks into it."""
    d = draw_offset(rng) * rng.permutation([1, 1, 1, 0.3, 0.3, 0.3])
    tried = [np.maximum(rig.nominal.R @ normalise(rng.normal(size=3)) @ normalise(rng.normal(size=3)), 0) ** 2 for _ in range(SUNS)]
    lit = max(tried, key=lambda each: float(np.std(each) - abs(np.mean(each > 0) - 0.5)))
    return Fault(
        size=lambda scale: Size(
            "sun into an optical sensor, offset of force where it is fullest", scale * lit.max() * measure_force(d), "N"
        ),
        distort=lambda W, scale: W + scale * np.outer(lit, d),
    )


def u_added_mass(_: np.random.Generator, rig: Rig) -> Fault:
    """Air goes along with a large light panel: inert across it, and without weight."""
    normal, at = normalise([0.7, -0.5, 0.5]), rig.body.com + np.array([0.02, 0.0, 0.1])

    def carry(W: Array, k: Kinematics, scale: float) -> Array:
        acceleration = k.feel_at(at) + k.turn_into_sensor(rig.tilted_gravity)
        force = 0.5 * scale * np.outer(acceleration @ normal, normal)
        return np.asarray(W + np.hstack([force, np.cross(at, force)]))

    return Fault(size=lambda scale: Size("air that a panel carries along, added mass across it", 0.5 * scale, "kg"), touch=carry)
