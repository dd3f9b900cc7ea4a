"""The joints are not where they are said to be: rods, keys, balancers, gears of two stages, belts."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import lag

EVERY = 5
"""Steps of the grid."""


def joff_rod(_: np.random.Generator, rig: Rig) -> Fault:
    """A rod of the linkage is too long: the wrist's pitch is off, and by a little else where the shoulder is elsewhere."""
    off = 1 + 0.06 * np.sin(rig.q[:, 1] - np.median(rig.q[:, 1]))
    by = np.zeros_like(rig.q)
    by[:, 3] = np.radians(0.6) * off
    return Fault(
        size=lambda scale: Size("pitch of the wrist off by a rod's length, a sixteenth of it goes with the shoulder", 0.6 * scale, "deg"),
        turn_joints=lambda q, scale: q + scale * by,
    )


def joff_key(rng: np.random.Generator, rig: Rig) -> Fault:
    """A key has sheared before: a joint of the forearm is off, by a tenth more on the side to which it is loaded."""
    joint = max(rig.joint_count - 3, 1)
    most = np.abs(rig.torques[:, joint]).max()
    by = np.zeros_like(rig.q)
    by[:, joint] = np.radians(0.6) * rng.choice([-1, 1]) * (1 + 0.1 * np.tanh(3 * rig.torques[:, joint] / most))
    return Fault(
        size=lambda scale: Size(f"zero of joint {joint + 1}, a tenth of it by its load's side", 0.6 * scale, "deg"),
        turn_joints=lambda q, scale: q + scale * by,
    )


def elast_balanced(_: np.random.Generator, rig: Rig) -> Fault:
    """The gears of shoulder and elbow give, but a balancer bears a part of the shoulder's load that depends on where it is."""
    stiffness = rig.arm.torque_limits * np.array([1, 110, 80, *[150] * (rig.joint_count - 3)])
    borne = 0.35 * np.abs(rig.torques[:, 1]).max() * np.sin(rig.q[:, 1])
    given = np.zeros_like(rig.torques)
    given[:, 1] = (rig.torques[:, 1] + np.sign(np.sum(rig.torques[:, 1] * -borne)) * borne) / stiffness[1]
    given[:, 2:] = rig.torques[:, 2:] / stiffness[2:]
    return Fault(
        size=lambda scale: Size("stiffness of joint 2, part of whose load a balancer bears", stiffness[1] / scale / 1e3, "kN m/rad"),
        turn_joints=lambda q, scale: q - scale * given,
    )


def backlash_stages(_: np.random.Generator, rig: Rig) -> Fault:
    """The gear of the joint whose load changes sides most often has two stages: the second falls over at another load than the first."""
    counts = []
    for j in range(1, rig.joint_count):
        most = np.abs(rig.torques[:, j]).max()
        counts.append(int(np.sum(np.abs(np.diff(_follow_side(rig.torques[::EVERY, j], 0.03 * most))) > 1)))
    joint = 1 + int(np.argmax(counts))
    load = rig.torques[::EVERY, joint]
    most = np.abs(load).max()
    falls = 0.65 * _follow_side(load, 0.03 * most) + 0.35 * _follow_side(load, 0.25 * most)
    side = lag(lag(np.interp(rig.t, rig.t[::EVERY], falls)[:, None], 0.02), 0.02)[:, 0]

    def fall(q: Array, scale: float) -> Array:
        q = q.copy()
        q[:, joint] -= np.radians(0.05) * scale * side
        return q

    what = f"half play of joint {joint + 1}, a third of it in a second stage, {max(counts)} reversals"
    return Fault(size=lambda scale: Size(what, 0.05 * scale, "deg"), turn_joints=fall)


def _follow_side(load: Array, least: float) -> Array:
    """(N,), -1 or 1: the side of the last of loads (N,), N m, that was beyond `least`."""
    last = np.maximum.accumulate(np.where(np.abs(load) > least, np.arange(len(load)), 0))
    return np.asarray(np.where(load[last] >= 0, 1.0, -1.0))


def ripple_belt(rng: np.random.Generator, rig: Rig) -> Fault:
    """Belts of two joints: their teeth mesh unevenly, more so on one side of a pulley that runs out of true."""
    belts = ((rig.joint_count - 2, 64.0, 1.0), (rig.joint_count - 3, 48.0, 0.7))
    phases = rng.uniform(0, 6.28, (2, 2))

    def err(q: Array, scale: float) -> Array:
        turned = q.copy()
        for (joint, teeth, share), (mesh, runout) in zip(belts, phases, strict=True):
            wave = np.sin(teeth * q[:, joint] + mesh) * (1 + 0.5 * np.sin(q[:, joint] + runout))
            turned[:, joint] += np.radians(1 / 60) * scale * share * wave
        return turned

    return Fault(
        size=lambda scale: Size(f"teeth of joint {rig.joint_count - 1}'s belt, 64 in a turn, more on one side", scale, "arcmin"),
        turn_joints=err,
    )
