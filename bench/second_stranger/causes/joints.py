"""The joints are not where they are said to be: zeros, gears that give, play or ripple."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import lag


def _list_wrist(rig: Rig) -> tuple[int, int]:
    return (3, 4) if rig.joint_count == 6 else (3, 5)


def joff_ecc(rng: np.random.Generator, rig: Rig) -> Fault:
    """Two encoders whose rings are off their zero and off their centre."""
    wrist, d, phases = _list_wrist(rig), np.radians([0.5, -0.35]), rng.uniform(0, 6, 2)

    def turn(q: Array, scale: float) -> Array:
        q = q.copy()
        for j, by, phase in zip(wrist, d, phases, strict=True):
            q[:, j] += scale * (by + 0.2 * by * np.sin(q[:, j] + phase))
        return q

    what = f"encoder zero of joint {wrist[0] + 1} (and joint {wrist[1] + 1} -0.7 of it), 20 % eccentric"
    return Fault(size=lambda scale: Size(what, 0.5 * scale, "deg"), turn_joints=turn)


def joff_one(_: np.random.Generator, rig: Rig) -> Fault:
    """One such encoder."""
    j = 4 if rig.joint_count == 6 else 5

    def turn(q: Array, scale: float) -> Array:
        q = q.copy()
        q[:, j] += np.radians(0.6) * scale * (1 + 0.15 * np.cos(q[:, j] - 0.4))
        return q

    what = f"encoder zero of joint {j + 1}, magnet ring 15 % eccentric"
    return Fault(size=lambda scale: Size(what, 0.6 * scale, "deg"), turn_joints=turn)


def elast_hard(_: np.random.Generator, rig: Rig) -> Fault:
    """Gears that are stiffer under load."""
    loaded = rig.arm.torque_limits * 260.0
    idle, knee = loaded * 0.5, rig.arm.torque_limits * 0.12
    share = np.ones(rig.joint_count)
    share[0] = 0.6
    torques = rig.torques

    def give(q: Array, scale: float) -> Array:
        return np.asarray(q - scale * share * (torques / loaded + (1 / idle - 1 / loaded) * knee * np.tanh(torques / knee)))

    what = "stiffness of joint 2 at large load (half of it near zero)"
    return Fault(size=lambda scale: Size(what, loaded[1] / scale / 1e3, "kN m/rad"), turn_joints=give)


def backlash_soft(_: np.random.Generator, rig: Rig) -> Fault:
    """Play of two joints, with grease in it."""
    wrist = _list_wrist(rig)

    def fall(q: Array, scale: float) -> Array:
        q = q.copy()
        for j, share in zip(wrist, (1.0, 0.7), strict=True):
            knee = 0.03 * np.abs(rig.torques[:, j]).max()
            side = np.tanh(rig.torques[:, j : j + 1] / knee)
            q[:, j] -= np.radians(0.05) * scale * share * lag(lag(side, 0.05), 0.03)[:, 0]
        return q

    what = f"half play of joint {wrist[0] + 1} (joint {wrist[1] + 1} 0.7 of it), crossed in 80 ms"
    return Fault(size=lambda scale: Size(what, 0.05 * scale, "deg"), turn_joints=fall)


def ripple_hd(rng: np.random.Generator, _: Rig) -> Fault:
    """Harmonic drives of three joints."""
    geared = [(4, 50, 1.0), (3, 50, 0.7), (2, 60, 0.5)]
    phase, arc = rng.uniform(0, 6, 6), np.radians(1 / 60)

    def err(q: Array, scale: float) -> Array:
        turned = q.copy()
        for i, (j, teeth, share) in enumerate(geared):
            wave = np.sin(2 * teeth * q[:, j] + phase[i]) + 0.35 * np.sin(teeth * q[:, j] + phase[i + 3])
            turned[:, j] += scale * share * arc * wave
        return turned

    what = "harmonic drive error at joint 5, twice per wave generator turn (N=50) + once"
    return Fault(size=lambda scale: Size(what, scale, "arcmin"), turn_joints=err)
