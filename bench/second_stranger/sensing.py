"""From the motors to the wrench that is sampled, with background and planted causes; and what is known of the motion afterwards."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Planted
from bench.second_stranger.kinematics import JointMotion, Kinematics, move_arm
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_body_wrench


@dataclass(frozen=True)
class Samples:
    """At the times of the samples: the wrench (M, 6), N and N m, without noise and offset; the joints as they are recorded, and how the
    sensor would move by these."""

    wrench: Array
    joints: JointMotion
    motion: Kinematics


def sample(rig: Rig, planted: Sequence[Planted]) -> Samples:
    """What is recorded, before the converter."""
    W = sense(rig, planted) + rig.background.drift
    times, q = rig.times + rig.jitter, rig.q
    for fault, scale in planted:
        if fault.delay is not None:
            times = times - fault.delay(rig.times, scale)
        if fault.report_joints is not None:
            q = fault.report_joints(q, scale)
    path = CubicSpline(rig.t, q)
    joints = JointMotion(path(rig.times), path(rig.times, 1), path(rig.times, 2))
    motion = move_arm(rig.arm, joints, rig.spread_gravity(len(rig.times)))
    return Samples(np.stack([np.interp(times, rig.t, W[:, i]) for i in range(6)], 1), joints, motion)


def sense(rig: Rig, planted: Sequence[Planted]) -> Array:
    """(N, 6), N and N m, sensor axes, on the grid: what the sensor puts out, without noise, offset and drift."""
    k = _move(rig, planted)
    W = find_body_wrench(k, rig.body)
    for fault, scale in planted:
        if fault.change_payload is not None:
            W = fault.change_payload(W, k, scale)
    for fault, scale in planted:
        if fault.touch is not None:
            W = fault.touch(W, k, scale)
    W = W * (1 + rig.background.gain)
    for fault, scale in planted:
        if fault.distort is not None:
            W = fault.distort(W, scale)
    return W


def _move(rig: Rig, planted: Sequence[Planted]) -> Kinematics:
    """How the sensor really moves."""
    if not any(fault.moves_sensor for fault, _ in planted):
        return rig.nominal
    q, gravity = rig.links, rig.tilted_gravity
    base = turned = moved = None
    for fault, scale in planted:
        if fault.turn_joints is not None:
            q = fault.turn_joints(q, scale)
        if fault.turn_gravity is not None:
            gravity = fault.turn_gravity(gravity, scale)
        if fault.turn_base is not None:
            base = fault.turn_base(scale)
        if fault.turn_sensor is not None:
            turned = fault.turn_sensor(scale)
        if fault.move_sensor is not None:
            moved = fault.move_sensor(scale)
    return rig.move(q, gravity, base, turned, moved)
