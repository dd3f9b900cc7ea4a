"""No family describes these, and they lie in electronics, programs, parameters and the floor."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction, draw_zero
from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S, derive, lag, rise

LEAK_S, DISCHARGE_S = 0.9, 25.0
FOREIGN_S, FOREIGN_SHARE = 0.01, 0.06


def _add_to_zero(zero: Array, shape: Array, what: str) -> Fault:
    """What a shape (N,) or (N, 6) adds to the reading, told by its force at most."""
    most = float(np.max(np.linalg.norm(zero[:3] * (shape if shape.ndim == 2 else shape[:, None])[:, :3], axis=1)))
    spread = shape if shape.ndim == 2 else shape[:, None]
    return Fault(size=lambda scale: Size(what, scale * most, "N"), distort=lambda W, scale: W + scale * zero * spread)


def u_triboelectric(rng: np.random.Generator, rig: Rig) -> Fault:
    """The sensor's cable makes charge as it is bent and twisted at the wrist, which leaks away within a second."""
    bent = rig.q[:, -2:] @ np.array([0.7, 0.5])
    charge = (bent[:, None] - lag(bent[:, None], LEAK_S))[:, 0]
    return _add_to_zero(draw_zero(rng, rig), charge / np.max(np.abs(charge)), "charge of a cable that is bent, at most")


def u_ground(rng: np.random.Generator, rig: Rig) -> Fault:
    """Currents of all drives return over the shield: the reading is lifted by the sum of their sizes."""
    current = np.sum(np.abs(rig.torques) / rig.arm.torque_limits, axis=1)
    return _add_to_zero(draw_zero(rng, rig), (current - current[0]) / np.ptp(current), "lift of the ground by the drives' currents, span")


def u_supply_sag(_: np.random.Generator, rig: Rig) -> Fault:
    """The drives' power drags the bridges' supply down: all that is read shrinks while the arm is fast."""
    power = np.sum(np.abs(rig.torques * derive(rig.q)), axis=1)
    sag = lag((power / np.max(power))[:, None], 0.05)
    return Fault(
        size=lambda scale: Size("reads less at the greatest power", 5 * scale, "%"), distort=lambda W, scale: W * (1 - 0.05 * scale * sag)
    )


def u_radio(rng: np.random.Generator, rig: Rig) -> Fault:
    """Radios of the shift keyed nearby are rectified by the amplifier: thirteen short bursts, each as strong as the last."""
    keyed = np.zeros(len(rig.t))
    for begin in rng.uniform(0.05, 0.95, 13) * rig.seconds:
        keyed = np.maximum(keyed, (rig.t > begin) & (rig.t < begin + rng.uniform(0.25, 1.1)))
    return _add_to_zero(draw_zero(rng, rig), lag(keyed[:, None], 0.01)[:, 0], "force that a radio feigns")


def u_beacon(rng: np.random.Generator, rig: Rig) -> Fault:
    """The lamp of a passing truck turns: light falls through a gap of the optical sensor as that faces it, 1.4 times in a second."""
    lamp = draw_direction(rng)
    facing = np.maximum(rig.nominal.R[:, :, 0] @ lamp, 0)
    flash = np.exp(6 * (np.cos(2 * np.pi * 1.4 * rig.t) - 1))
    return _add_to_zero(draw_zero(rng, rig), facing * flash, "force that flashes feign")


def u_weld(rng: np.random.Generator, rig: Rig) -> Fault:
    """A welding gun beside: while it is on, its field, fixed in the hall, makes voltages by how the sensor is turned in it."""
    field, mix = draw_direction(rng), rng.normal(size=(3, 6)) * rig.noise_std * 8
    on = np.zeros(len(rig.t))
    for middle in np.linspace(0.1, 0.9, 7):
        begin = (middle + rng.uniform(-0.04, 0.04)) * rig.seconds
        on = np.maximum(on, rise((rig.t - begin) / 0.1) * rise((begin + rng.uniform(1.5, 3.5) - rig.t) / 0.1))
    made = on[:, None] * (np.einsum("nij,i->nj", rig.nominal.R, field) @ mix)
    size = float(np.max(np.linalg.norm(made[:, :3], axis=1)))
    return Fault(size=lambda scale: Size("force that a welding field feigns", scale * size, "N"), distort=lambda W, scale: W + scale * made)


def u_charge(_: np.random.Generator, __: Rig) -> Fault:
    """A piezo sensor loses its charge: what stays is forgotten within half a minute, and what changes is read."""
    share = np.array([1, 1, 0.7, 0.9, 0.9, 1.1])

    def leak(W: Array, scale: float) -> Array:
        gone = W - W[0]
        lost = np.zeros_like(W)
        for i, each in enumerate(DISCHARGE_S / np.maximum(scale * share, 1e-3)):
            lost[:, i] = lag(gone[:, i : i + 1], float(each))[:, 0]
        return np.asarray(W - lost)

    return Fault(size=lambda scale: Size("time constant of the discharge", DISCHARGE_S / max(scale, 1e-3), "s"), distort=leak)


def u_stuck_bit(_: np.random.Generator, rig: Rig) -> Fault:
    """A bit of one converter is always set: codes with it are right and codes without it too high."""
    channel = int(np.argmax(np.ptp(rig.load, axis=0) / rig.noise_std))

    def stick(W: Array, scale: float) -> Array:
        bit = 12 * scale * rig.noise_std[channel]
        read = W.copy()
        read[:, channel] += bit * (np.mod(np.floor(W[:, channel] / bit), 2) == 0)
        return read

    return Fault(
        size=lambda scale: Size("bit that is always set, in one channel", 12 * scale * float(rig.noise_std[channel]), "N or N m"),
        distort=stick,
    )


def u_autorange(_: np.random.Generator, rig: Rig) -> Fault:
    """The amplifier changes its range at a load and back at a smaller one; the other range has another zero and gain."""
    channels = np.argsort(np.ptp(rig.load, axis=0) / rig.noise_std)[-3:]
    level, zero = np.quantile(np.abs(rig.load), 0.6, axis=0), 6 * rig.noise_std

    def change(W: Array, scale: float) -> Array:
        read = W.copy()
        for i in channels:
            size = np.abs(W[:, i])
            told = np.where(size > level[i], 1, np.where(size < 0.8 * level[i], 0, -1))
            last = np.maximum.accumulate(np.where(told >= 0, np.arange(len(told)), 0))
            coarse = np.maximum(told[last], 0)
            read[:, i] += scale * coarse * (zero[i] + 0.01 * W[:, i])
        return read

    return Fault(size=lambda scale: Size("zero of the coarse range, noise standard deviations", 6 * scale, "sigma"), distort=change)


def u_deadband(_: np.random.Generator, rig: Rig) -> Fault:
    """The firmware mutes the torques near nothing, so that a display stands still: below a level it says zero, above it all."""
    level = np.append(np.zeros(3), 0.25 * np.quantile(np.abs(rig.load[:, 3:]), 0.9, axis=0))

    def mute(W: Array, scale: float) -> Array:
        x = np.abs(W) / np.maximum(scale * level, 1e-12)
        return np.asarray(W * (1 - 1 / (1 + x**8)))

    return Fault(size=lambda scale: Size("torques below this are said to be zero, tx", scale * float(level[3]), "N m"), distort=mute)


def u_slew(_: np.random.Generator, rig: Rig) -> Fault:
    """A filter against shocks lets no channel change faster than so much in a second."""
    fast = np.quantile(np.abs(derive(rig.load)), 0.99, axis=0)

    def limit(W: Array, scale: float) -> Array:
        steps, read = fast * STEP_S / np.sqrt(scale), W.copy()
        for i, step in enumerate(steps.tolist()):
            x = W[0, i]
            for n, wanted in enumerate(W[:, i].tolist()):
                x += min(max(wanted - x, -step), step)
                read[n, i] = x
        return read

    return Fault(size=lambda scale: Size("fx changes at most by so much", float(fast[0] / np.sqrt(scale)), "N/s"), distort=limit)


def u_foreign(rng: np.random.Generator, rig: Rig) -> Fault:
    """Two sensors on a bus have one number: now and then a message of the other, which stands loaded elsewhere, is taken for ours."""
    count = int(len(rig.t) * STEP_S / FOREIGN_S) + 1
    theirs = np.repeat(rng.random(count) < FOREIGN_SHARE, round(FOREIGN_S / STEP_S))[: len(rig.t), None]
    load = 4 * draw_zero(rng, rig)

    def mix(W: Array, scale: float) -> Array:
        return np.asarray(np.where(theirs, W + scale * (load - 0.3 * (W - W.mean(0))), W))

    size = float(np.linalg.norm(load[:3]))
    return Fault(size=lambda scale: Size("load of another sensor in 6 % of the time, about", scale * size, "N"), distort=mix)


def u_ratio(rng: np.random.Generator, rig: Rig) -> Fault:
    """A file of parameters has the ratio of a gear a little wrong, so the joint turns farther than it says."""
    joint = int(rng.integers(1, 4))
    sign = int(rng.choice([-1, 1]))
    by = np.arange(rig.joint_count) == joint
    return Fault(
        size=lambda scale: Size(f"ratio of joint {joint + 1} wrong by", 0.5 * sign * scale, "%"),
        turn_joints=lambda q, scale: q * (1 + 0.005 * sign * scale * by),
    )


def u_coupling(rng: np.random.Generator, _: Rig) -> Fault:
    """The wrist's bevel gears drive each other, and the controller leaves that out: the last joint turns with the one before."""
    sign = int(rng.choice([-1, 1]))

    def couple(q: Array, scale: float) -> Array:
        turned = q.copy()
        turned[:, -1] += sign * 0.015 * scale * q[:, -2]
        turned[:, -2] += sign * 0.006 * scale * q[:, -3]
        return turned

    return Fault(size=lambda scale: Size("the last joint turns by so much of the one before", 1.5 * sign * scale, "%"), turn_joints=couple)


def u_gantry(rng: np.random.Generator, rig: Rig) -> Fault:
    """The base hangs on a gantry that another robot shares: each time that one brakes, all swings sideways and dies out."""
    along = normalise(np.append(rng.normal(size=2), 0.1 * rng.normal()))
    swing = np.zeros(len(rig.t))
    for begin in np.sort(rng.uniform(0.05, 0.95, 9)) * rig.seconds:
        since = np.maximum(rig.t - begin, 0)
        swing += rng.uniform(0.6, 1.2) * rng.choice([-1, 1]) * np.exp(-since / 1.1) * np.sin(2 * np.pi * 2.3 * since)
    return Fault(
        size=lambda scale: Size("acceleration of the gantry sideways, about", 0.2 * scale, "m/s^2"),
        turn_gravity=lambda g, scale: g - 0.2 * scale * np.outer(swing, along),
    )


def u_lift(rng: np.random.Generator, rig: Rig) -> Fault:
    """The column under the base goes up and down between jobs, which no axis of the log tells."""
    up = -normalise(rig.gravity)
    speed = np.zeros(len(rig.t))
    for place, middle in enumerate(np.linspace(0.12, 0.85, 6)):
        begin = (middle + rng.uniform(-0.03, 0.03)) * rig.seconds
        speed += (-1) ** place * (rise((rig.t - begin) / 0.7) - rise((rig.t - begin - 2.0) / 0.7))
    acceleration = derive(speed)
    return Fault(
        size=lambda scale: Size("speed of the lift", 0.15 * scale, "m/s"),
        turn_gravity=lambda g, scale: g - 0.15 * scale * np.outer(acceleration, up),
    )
