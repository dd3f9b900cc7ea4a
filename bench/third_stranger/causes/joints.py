"""The joints are not where they are said to be: mastering, gears that give and lose, wear, cycloids."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import follow_dahl, resonate

EVERY = 5
"""Steps of the grid."""


def joff_remaster(_: np.random.Generator, rig: Rig) -> Fault:
    """Mastered with the tool on and cold: a big joint and one of the wrist are off, a tenth more when they are warm."""
    by = np.zeros(rig.joint_count)
    by[1], by[-2] = np.radians(0.35), np.radians(0.5)
    warm = 0.92 + 0.1 * (1 - np.exp(-rig.t / (0.4 * rig.seconds)))
    what = f"zero of joint {rig.joint_count - 1}, joint 2 off by 0.7 of it, a tenth of it comes with warmth"
    return Fault(size=lambda scale: Size(what, 0.5 * scale, "deg"), turn_joints=lambda q, scale: q + scale * np.outer(warm, by))


def joff_tooth(rng: np.random.Generator, rig: Rig) -> Fault:
    """The belt of a wrist joint jumped a tooth before the recording."""
    by = np.zeros(rig.joint_count)
    by[-2] = np.radians(0.7) * rng.choice([-1, 1])
    return Fault(
        size=lambda scale: Size(f"zero of joint {rig.joint_count - 1}", np.degrees(scale * by[-2]), "deg"),
        turn_joints=lambda q, scale: q + scale * by,
    )


def elast_windup(_: np.random.Generator, rig: Rig) -> Fault:
    """The gears of two joints wind up under load, and do not unwind wholly."""
    stiffness = rig.arm.torque_limits * 60.0
    joints, losses = (1, 2), (0.08, 0.12)
    most = np.abs(rig.torques).max(0)
    given = np.zeros_like(rig.torques)
    for j, loss in zip(joints, losses, strict=True):
        stuck = follow_dahl(np.diff(rig.torques[::EVERY, j] / most[j]), 0.2)
        given[:, j] = (rig.torques[:, j] + loss * most[j] * np.interp(rig.t, rig.t[::EVERY], stuck)) / stiffness[j]
    return Fault(
        size=lambda scale: Size(
            "stiffness of joints 2 and 3 of such, a tenth of it not unwound, joint 2", stiffness[1] / scale / 1e3, "kN m/rad"
        ),
        turn_joints=lambda q, scale: q - scale * given,
    )


def backlash_worn(_: np.random.Generator, rig: Rig) -> Fault:
    """The gear of the joint whose load changes sides most often is worn where it works most, and bounces when it falls over."""
    loads = [_list_sides(rig.torques[::EVERY, j], 0.06 * np.abs(rig.torques[:, j]).max()) for j in range(1, rig.joint_count - 1)]
    flips = [int(np.sum(np.abs(np.diff(side)) > 1)) for side in loads]
    place = int(np.argmax(flips))
    joint, side = place + 1, np.interp(rig.t, rig.t[::EVERY], loads[place])
    falls = resonate(resonate(side[:, None], 2.4, 0.55), 8.0, 0.8)[:, 0]
    worn = 0.5 + 0.5 * np.exp(-(((rig.q[:, joint] - np.median(rig.q[:, joint])) / 0.6) ** 2))

    def fall(q: Array, scale: float) -> Array:
        q = q.copy()
        q[:, joint] -= np.radians(0.06) * scale * worn * falls
        return q

    what = f"half play of joint {joint + 1} where it is worn (half of it elsewhere), {flips[place]} flips, with a bounce"
    return Fault(size=lambda scale: Size(what, 0.06 * scale, "deg"), turn_joints=fall)


def _list_sides(load: Array, least: float) -> Array:
    """(N,), -1 or 1: the side of the last of loads (N,), N m, that was beyond `least`."""
    last = np.maximum.accumulate(np.where(np.abs(load) > least, np.arange(len(load)), 0))
    return np.asarray(np.where(load[last] >= 0, 1.0, -1.0))


def ripple_cycloid(rng: np.random.Generator, rig: Rig) -> Fault:
    """Cycloidal gears of two joints whose orders are not whole, erring more under load."""
    geared = ((2, 81.4, 1.0), (rig.joint_count - 2, 57.7, 0.8))
    phases = rng.uniform(0, 6.28, (2, 2))

    def err(q: Array, scale: float) -> Array:
        turned = q.copy()
        for (joint, order, share), phase in zip(geared, phases, strict=True):
            load = np.abs(rig.torques[:, joint]) / np.abs(rig.torques[:, joint]).max()
            wave = np.sin(order * q[:, joint] + phase[0]) + 0.4 * np.sin(order / 2 * q[:, joint] + phase[1])
            turned[:, joint] += np.radians(1 / 60) * scale * share * (0.7 + 0.5 * load) * wave
        return turned

    return Fault(
        size=lambda scale: Size("error of joint 3's gear, 81.4 waves in a turn and half of that, more under load", scale, "arcmin"),
        turn_joints=err,
    )
