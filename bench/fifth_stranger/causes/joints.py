"""The joints are not where their encoders say: belts, a swapped motor, soft reducers, play, ripples."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig

TEETH = (19, 23, 29)


def joff_belt(rng: np.random.Generator, rig: Rig) -> Fault:
    """A belt of the wrist jumped by part of a tooth, and its wheel runs out a little."""
    joint = rig.joint_count - int(rng.integers(2, 4))
    sign = int(rng.choice([-1, 1]))

    def turn(q: Array, scale: float) -> Array:
        by = np.zeros_like(q)
        by[:, joint] = sign * np.radians(0.5) * scale * (1 + 0.08 * np.sin(q[:, joint]))
        return q + by

    return Fault(size=lambda scale: Size(f"zero of joint {joint + 1} off", 0.5 * sign * scale, "deg"), turn_joints=turn)


def joff_swap(rng: np.random.Generator, rig: Rig) -> Fault:
    """Motors of the second and the fourth joint were swapped out and zeroed by eye."""
    by = np.zeros(rig.joint_count)
    by[[1, 3]] = np.radians([0.4, 0.6]) * rng.choice([-1, 1], 2)
    return Fault(
        size=lambda scale: Size("zero of joint 2 off (joint 4 by 1.5 of it)", float(np.degrees(by[1])) * scale, "deg"),
        turn_joints=lambda q, scale: q + scale * by,
    )


def elast_reducer(_: np.random.Generator, rig: Rig) -> Fault:
    """The reducers of the second and third joint are worn: soft at small torques, stiffer at large ones."""
    give = np.zeros((len(rig.t), rig.joint_count))
    for joint, share in ((1, 1.0), (2, 0.7)):
        x = rig.torques[:, joint] / np.max(np.abs(rig.torques[:, joint]))
        give[:, joint] = share * x / (1 + 0.2 * np.abs(x))
    return Fault(
        size=lambda scale: Size("most that joint 2 gives", 0.2 * scale / 1.2, "deg"),
        turn_joints=lambda q, scale: q - np.radians(0.2) * scale * give,
    )


def elast_wrist(_: np.random.Generator, rig: Rig) -> Fault:
    """The slim gears of the wrist twist under the payload, in proportion."""
    torques = rig.torques * (np.arange(rig.joint_count) >= rig.joint_count - 3)
    most = float(np.max(np.abs(torques)))
    return Fault(
        size=lambda scale: Size("stiffness of the wrist's joints", most / np.radians(0.2) / scale / 1e3, "kN m/rad"),
        turn_joints=lambda q, scale: q - np.radians(0.2) * scale * torques / most,
    )


def backlash_worm(_: np.random.Generator, rig: Rig) -> Fault:
    """Play of worn gears in the wrist's first two joints: each lies on one flank or the other, softly where the torque is small."""
    joints = [rig.joint_count - 3, rig.joint_count - 2]
    torques = rig.torques[:, joints]
    side = np.zeros((len(rig.t), rig.joint_count))
    side[:, joints] = np.tanh(torques / (0.06 * np.max(np.abs(torques), axis=0))) * [1, 0.7]
    return Fault(
        size=lambda scale: Size(f"half of the play of joint {joints[0] + 1} (of the next 0.7 of it)", 0.06 * scale, "deg"),
        turn_joints=lambda q, scale: q - np.radians(0.06) * scale * side,
    )


def ripple_cyclo(rng: np.random.Generator, rig: Rig) -> Fault:
    """The discs of a cycloidal reducer make twice their teeth of waves in a turn, and half of that once more; it swells with the load."""
    joint, teeth = 2, int(rng.choice(TEETH))
    x = np.abs(rig.torques[:, joint]) / np.max(np.abs(rig.torques[:, joint]))
    first, second = rng.uniform(0, 2 * np.pi, 2)

    def turn(q: Array, scale: float) -> Array:
        by = np.zeros_like(q)
        wave = np.sin(2 * teeth * q[:, joint] + first) + 0.4 * np.sin(teeth * q[:, joint] + second)
        by[:, joint] = np.radians(0.5 / 60) * scale * (0.8 + 0.2 * x) * wave
        return q + by

    return Fault(size=lambda scale: Size(f"ripple of joint 3, {2 * teeth} waves in a turn", 0.5 * scale, "arcmin"), turn_joints=turn)
