"""Causes in the arm and under it that no diagnosis has a name for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pinocchio as pin
from scipy.interpolate import CubicSpline

from bench.second_stranger.arms import load_model
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import JointMotion, Kinematics, move_arm
from bench.second_stranger.rig import TORQUES_EVERY, Rig
from bench.second_stranger.rigid_body import find_body_wrench
from bench.second_stranger.signals import STEP_S, derive, lag, resonate

BENT = 2
"""Place of the link that was bent."""


def u_bent_link(_: np.random.Generator, rig: Rig) -> Fault:
    """A crash has twisted a link: the axis behind it no longer lies as it did to the one before."""
    path = CubicSpline(rig.t, rig.links)
    joints = JointMotion(rig.links, path(rig.t, 1), path(rig.t, 2))
    link = min(BENT, rig.joint_count - 4)

    def bend(W: Array, k: Kinematics, scale: float) -> Array:
        d, a, alpha = rig.arm.dh[link]
        dh = (*rig.arm.dh[:link], (d, a, alpha + np.radians(scale)), *rig.arm.dh[link + 1 :])
        bent = move_arm(replace(rig.arm, dh=dh), joints, rig.tilted_gravity)
        return W + find_body_wrench(bent, rig.body) - find_body_wrench(k, rig.body)

    return Fault(size=lambda scale: Size(f"link {link + 1} twisted about its length", scale, "deg"), change_payload=bend)


def u_coupling(_: np.random.Generator, __: Rig) -> Fault:
    """The wrist's gears turn each other, by another ratio than the controller reckons with."""

    def couple(q: Array, scale: float) -> Array:
        turned = q.copy()
        turned[:, -1] += 0.012 * scale * q[:, -2]
        turned[:, -2] += 0.009 * scale * q[:, -3]
        return turned

    return Fault(
        size=lambda scale: Size("wrist coupling, angle of the last joint for one of that before it", 1.2 * scale, "%"), turn_joints=couple
    )


def u_pedestal(_: np.random.Generator, rig: Rig) -> Fault:
    """A tall pedestal sways with what the arm does on it."""
    hz, damping = 2.7, 0.05
    by = _find_acceleration_of_arm(rig) * np.array([1, 0.8, 0])
    swayed = derive(derive(resonate(-by / (2 * np.pi * hz) ** 2, hz, damping)))
    return Fault(
        size=lambda scale: Size("pedestal sways at 2.7 Hz with the arm's own motion, share of the mass that moves", 0.1 * scale, "-"),
        turn_gravity=lambda g, scale: g - 0.1 * scale * swayed,
    )


def _find_acceleration_of_arm(rig: Rig) -> Array:
    """(N, 3), m/s^2, base axes, of the arm's centre of mass."""
    model = load_model(rig.arm)
    data = model.createData()
    dq = derive(rig.q)
    ddq = derive(dq)
    some = np.arange(0, len(rig.t), TORQUES_EVERY)
    found = []
    for i in some:
        pin.centerOfMass(model, data, rig.q[i], dq[i], ddq[i])
        found.append(data.acom[0].copy())
    return np.asarray(CubicSpline(rig.t[some], np.array(found))(rig.t))


def u_weave(rng: np.random.Generator, rig: Rig) -> Fault:
    """Weaving is put on top of the way behind the interface that records it, at another pace on each seam."""
    moving = np.linalg.norm(derive(rig.q), axis=1)
    is_on = lag(lag((moving > 0.25)[:, None] * 1.0, 0.12), 0.12)[:, 0]
    paces = np.repeat(rng.uniform(1.6, 3.6, len(rig.t) // 9000 + 1), 9000)[: len(rig.t)]
    angle = 2 * np.pi * np.cumsum(paces) * STEP_S
    by = np.zeros_like(rig.q)
    by[:, -2], by[:, -3] = is_on * np.sin(angle), 0.5 * is_on * np.cos(angle)
    return Fault(
        size=lambda scale: Size("weaving of the wrist on top of the recorded way, 1.6 to 3.6 Hz", 0.2 * scale, "deg"),
        turn_joints=lambda q, scale: q + np.radians(0.2) * scale * by,
    )
