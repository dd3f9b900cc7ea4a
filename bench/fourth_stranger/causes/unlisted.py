"""Causes in the machine, the sensor and beside them that no diagnosis has a name for."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_zero, find_speed_of_joints, spread_over_grid, step_of
from bench.second_stranger.array import Array
from bench.second_stranger.draws import measure_force, normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_body_wrench, push
from bench.second_stranger.rotations import tilt_vectors
from bench.second_stranger.signals import lag

EVERY = 20
"""Steps of the grid."""
STILL_RAD_S, STILL_S = 0.004, 0.5
"""Below which speed, and after how long, a reading is stable."""


def u_furnace(rng: np.random.Generator, rig: Rig) -> Fault:
    """An open furnace shines on the sensor: its zero goes off where it comes near, and comes back when it has gone."""
    d, p = draw_zero(rng, rig), rig.nominal.p
    away = p - p.mean(0)
    furnace = p[int(np.argmax(away @ normalise(rng.normal(size=3))))] * 1.1
    width = 0.9 * float(np.linalg.norm(np.std(p, axis=0)))
    heat = lag(np.exp(-0.5 * np.sum((p - furnace) ** 2, 1) / width**2)[:, None], 0.8)[:, 0]
    return Fault(
        size=lambda scale: Size("furnace shines on the sensor where it is near, force", scale * float(heat.max()) * measure_force(d), "N"),
        distort=lambda W, scale: W + scale * np.outer(heat, d),
    )


def u_mux(rng: np.random.Generator, rig: Rig) -> Fault:
    """The channels are converted one after another, and written as if at once: some come early, others late."""
    late = (np.arange(6) - 2.5)[rng.permutation(6)] / 2.5

    def turn(W: Array, scale: float) -> Array:
        return np.stack([np.interp(rig.t - 0.02 * scale * late[i], rig.t, W[:, i]) for i in range(6)], 1)

    return Fault(size=lambda scale: Size("channels converted one after another, from first to last", 40 * scale, "ms"), distort=turn)


def u_partner(_: np.random.Generator, rig: Rig) -> Fault:
    """A second arm holds the other end and lags behind: it drags by the speed, not alike in all directions, and against turning too."""
    at, out = 1.6 * rig.body.com, float(np.linalg.norm(rig.body.com))
    drags = np.array([1.0, 0.55, 0.8])

    def drag(W: Array, k: Kinematics, scale: float) -> Array:
        force = -0.05 * scale * rig.body.mass * 9.8 * drags * k.find_speed(at)
        W = push(W, k, force, at)
        W[:, 3:] += 0.05 * scale * rig.body.mass * 9.8 * 0.5 * out**2 * k.omega
        return W

    return Fault(
        size=lambda scale: Size("second arm drags by its lag, fastest along x", 0.05 * scale * rig.body.mass * 9.8, "N s/m"), touch=drag
    )


def u_wobble(rng: np.random.Generator, rig: Rig) -> Fault:
    """The last bearing's race is dented: the flange nods twice in a turn."""
    phase, q = rng.uniform(0, 6.28), rig.q[:, -1]
    about_x, about_y = np.cos(2 * q + phase), 0.5 * np.sin(2 * q + phase)

    def nod(W: Array, k: Kinematics, scale: float) -> Array:
        by = -np.radians(0.5) * scale * about_x, -np.radians(0.5) * scale * about_y
        nodded = Kinematics(k.R, k.p, k.v, *(tilt_vectors(x, *by) for x in (k.omega, k.alpha, k.u)))
        return W + find_body_wrench(nodded, rig.body) - find_body_wrench(k, rig.body)

    return Fault(size=lambda scale: Size("flange nods twice in a turn of the last joint, by", 0.5 * scale, "deg"), change_payload=nod)


def u_zero_tracking(_: np.random.Generator, rig: Rig) -> Fault:
    """The amplifier is one for scales: where the reading is stable, it takes that for zero, little by little."""
    speed = find_speed_of_joints(rig)[::EVERY]
    last = np.maximum.accumulate(np.where(speed > STILL_RAD_S, np.arange(len(speed)), -(10**6)))
    is_stable = (np.arange(len(speed)) - last) * step_of(EVERY) > STILL_S

    def track(W: Array, scale: float) -> Array:
        read, kept = np.zeros(6), np.empty((len(speed), 6))
        for i, (w, stable) in enumerate(zip(W[::EVERY] - W[0], is_stable.tolist(), strict=True)):
            if stable:
                read = read + step_of(EVERY) * scale / 40 * (w - read)
            kept[i] = read
        return W - spread_over_grid(rig, kept, EVERY)

    return Fault(size=lambda scale: Size("zero goes after a stable reading, time constant", 40 / scale, "s"), distort=track)
