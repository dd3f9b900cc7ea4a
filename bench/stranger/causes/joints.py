"""The joints are not where they are said to be, or cost torque: zeros, gears that give, play or ripple, and friction."""

from __future__ import annotations

import numpy as np

from bench.stranger.array import Array
from bench.stranger.draws import draw_log, draw_sign
from bench.stranger.fault import Fault
from bench.stranger.rig import DEGREE, Rig
from bench.stranger.signals import lag_twice


def lose_zeros_of_wrist(rng: np.random.Generator, rig: Rig) -> Fault:
    """Of two joints."""
    by = np.zeros(rig.joint_count)
    by[rig.arm.pitch] = draw_sign(rng) * draw_log(rng, 0.3, 0.9) * DEGREE
    by[rig.arm.mid] = draw_sign(rng) * draw_log(rng, 0.3, 0.9) * DEGREE
    return _lose_zeros("encoder zeros of two wrist joints off after a belt change", by)


def lose_all_zeros(rng: np.random.Generator, rig: Rig) -> Fault:
    """Of every joint."""
    return _lose_zeros("all zeros off (mastering lost): random on every joint", rng.normal(size=rig.joint_count) * 0.35 * DEGREE)


def lose_zeros_of_last_joint(rng: np.random.Generator, rig: Rig) -> Fault:
    """And a little of the pitch joint."""
    by = np.zeros(rig.joint_count)
    by[rig.arm.roll] = draw_sign(rng) * draw_log(rng, 0.5, 1.2) * DEGREE
    by[rig.arm.pitch] = 0.4 * draw_sign(rng) * abs(by).max()
    return _lose_zeros("zeros of the last joint and the pitch joint", by)


def _lose_zeros(variant: str, by: Array) -> Fault:
    """By angles (n,), rad."""
    return Fault(
        family="joint_offset",
        variant=variant,
        size=lambda scale: {"offset_deg": by * scale / DEGREE},
        turn_joints=lambda scale: by * scale,
    )


def give_under_load(rng: np.random.Generator, rig: Rig) -> Fault:
    """The gears of all joints, softer near zero load."""
    K = rng.uniform(4e3, 9e3, rig.joint_count)
    K[3:] = rng.uniform(1.5e3, 4e3, rig.joint_count - 3)

    def give(scale: float) -> Array:
        G = rig.loads.of_all
        return np.asarray(scale * G / K * (1.25 - 0.35 * np.tanh(np.abs(G) / 25.0)))

    return Fault(
        family="joint_elasticity",
        variant="stiffening harmonic-drive characteristic (softer near zero load), all joints, gravity load of links and payload",
        size=lambda scale: {"K_Nm_per_rad": K / scale},
        turn_joints=give,
        limits=(0.3, 3),
    )


def play_in_gears(rng: np.random.Generator, rig: Rig) -> Fault:
    """Of the wrist: a joint lies on the side to which gravity presses it."""
    joints = [rig.arm.pitch, rig.arm.mid, rig.arm.roll]
    half = np.array([draw_log(rng, 0.08, 0.2), draw_log(rng, 0.08, 0.2), draw_log(rng, 0.08, 0.25)]) * DEGREE
    flip = rng.uniform(0.03, 0.12, 3)

    def fall(scale: float) -> Array:
        off = np.zeros((rig.steps, rig.joint_count))
        i = np.arange(rig.steps)
        for joint, by, least in zip(joints, half, flip, strict=True):
            side = _find_side(rig.loads.of_all[::5, joint], least)
            off[:, joint] = lag_twice(np.interp(i, i[::5], side), 7) * by * scale
        return off

    return Fault(
        family="joint_backlash",
        variant="play in three wrist gears; flips when the gravity load reverses beyond the friction of the seal, with a soft landing",
        size=lambda scale: {"half_play_deg": half * scale / DEGREE, "joints": joints, "flip_Nm": flip},
        turn_joints=fall,
        wanted=(1.8, 8),
        limits=(0.3, 3),
    )


def _find_side(load: Array, least: float) -> Array:
    """(N,), -1 or 1, of loads (N,) in N m: the sign of the last one that was beyond `least`."""
    side = np.empty(len(load))
    at = float(np.sign(load[0])) or 1.0
    for i, x in enumerate(load):
        if x > least:
            at = 1.0
        elif x < -least:
            at = -1.0
        side[i] = at
    return side


def ripple(rng: np.random.Generator, rig: Rig) -> Fault:
    """The gears of all joints err with the turns of their wave generators."""
    order = np.array(rng.choice([50, 80, 100, 120, 160], rig.joint_count), float)
    A = rng.uniform(0.5, 1.2, rig.joint_count) / 60 * DEGREE
    phase = rng.uniform(0, 6.28, (2, rig.joint_count))

    def err(scale: float) -> Array:
        q = rig.q
        once = (1 + 0.3 * np.sin(3 * q)) * np.sin(order * q + phase[0])
        return np.asarray(scale * A * (once + 0.5 * np.sin(2 * order * q + phase[1])))

    return Fault(
        family="gear_ripple",
        variant="transmission error of every joint: first and second order of the wave generator, modulated over the turn",
        size=lambda scale: {"amplitude_arcmin": A * scale / DEGREE * 60, "order": order},
        turn_joints=err,
        limits=(0.2, 4),
    )


def rub(rng: np.random.Generator, rig: Rig) -> Fault:
    """More friction than usual, in the torques alone: what the arm lags behind its command is the same delay as ever."""
    n = rig.joint_count
    coulomb, stribeck, viscous = rng.uniform(3, 9, n), rng.uniform(1, 4, n), rng.uniform(4, 12, n)
    coulomb[3:] *= 0.35
    stribeck[3:] *= 0.3
    viscous[3:] *= 0.3

    def resist(torque: Array, speed: Array, _: float) -> Array:
        sliding = coulomb + 0.06 * np.abs(torque) + stribeck * np.exp(-(np.abs(speed / 0.03) ** 0.8))
        return np.asarray(np.tanh(speed / 0.003) * sliding + viscous * np.sign(speed) * np.abs(speed) ** 0.85)

    return Fault(
        family="joint_friction",
        variant="Stribeck with load-dependent Coulomb part and sub-linear viscous part, in tau; the wrench is untouched",
        size=lambda _: {"coulomb": coulomb, "stribeck": stribeck, "viscous": viscous},
        rub_joints=resist,
        fixed=True,
        facts={
            "note": "joints' side: no gap in the wrench is planted (the command runs ahead of the measured q by the usual lag)",
            "visible_sigma": 0.0,
            "visible_in": "tau",
            "size_tau_Nm": coulomb,
        },
    )
