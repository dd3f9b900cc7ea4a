"""From the motors to the wrench that is sampled, with background and planted causes; and what a rigid payload alone would make of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from bench.stranger.array import Array
from bench.stranger.fault import Planted
from bench.stranger.kinematics import Kinematics, move_arm
from bench.stranger.rig import GRAVITY, Rig
from bench.stranger.rigid_body import find_wrench
from bench.stranger.rotations import rotate_by_vector, turn_vector
from bench.stranger.signals import derive


def sense(rig: Rig, planted: Sequence[Planted]) -> Array:
    """(M, 6), N and N m, sensor axes: what the sensor puts out at the times of the samples, without noise."""
    k = _move(rig, planted)
    mass: float | Array = rig.body.mass
    first_moment, inertia = rig.body.first_moment, rig.body.inertia
    for fault, scale in planted:
        if fault.change_payload is not None:
            change = fault.change_payload(scale)
            mass, first_moment, inertia = mass + change.mass, first_moment + change.first_moment, inertia + change.inertia
    W = find_wrench(k, mass, first_moment, inertia)
    for fault, scale in planted:
        if fault.add_wrench is not None:
            W = W + fault.add_wrench(k, scale)
    W = W * (1 + rig.background.gain)
    for fault, scale in planted:
        if fault.distort is not None:
            W = fault.distort(W, scale)
    W = W + rig.sensor.offset + rig.background.drift
    for fault, scale in planted:
        if fault.put_out is not None:
            W = fault.put_out(W, scale)
    times = rig.times
    for fault, scale in planted:
        if fault.shift_times is not None:
            times = fault.shift_times(times, scale)
    return rig.sample(W, times)


def find_reported_joints(rig: Rig, planted: Sequence[Planted]) -> tuple[Array, Array, Array]:
    """(N, n) each, rad and its derivatives: the joints as they are recorded."""
    q, dq, ddq = rig.q, rig.dq, rig.ddq
    for fault, scale in planted:
        if fault.report_joints is not None:
            q = fault.report_joints(scale)
            dq = derive(q)
            ddq = derive(dq)
    return q, dq, ddq


def find_reported_kinematics(rig: Rig, planted: Sequence[Planted]) -> Kinematics:
    """How the sensor moves by the joints as they are recorded, on the grid."""
    if all(fault.report_joints is None for fault, _ in planted):
        return rig.nominal
    return move_arm(rig.arm, *find_reported_joints(rig, planted), GRAVITY)


def predict(rig: Rig, planted: Sequence[Planted]) -> Array:
    """(M, 6), N and N m, sensor axes: what the payload would ask of a perfect sensor, by the joints as they are recorded."""
    body = rig.body
    return rig.sample(find_wrench(find_reported_kinematics(rig, planted), body.mass, body.first_moment, body.inertia))


def _move(rig: Rig, planted: Sequence[Planted]) -> Kinematics:
    """How the sensor really moves."""
    off = _turn_links(rig, planted)
    mounting = acceleration = None
    for fault, scale in planted:
        if fault.turn_sensor is not None:
            mounting = fault.turn_sensor(scale)
        if fault.shake_base is not None:
            acceleration = fault.shake_base(scale)
    q, dq, ddq = rig.q + off, rig.dq + derive(off), rig.ddq + derive(derive(off))
    return move_arm(rig.arm, q, dq, ddq, _turn_gravity(rig, planted), acceleration, mounting)


def _turn_links(rig: Rig, planted: Sequence[Planted]) -> Array:
    """(N, n), rad, by which the links are turned against the motors."""
    off = np.zeros((rig.steps, rig.joint_count)) + rig.background.zeros
    if rig.background.stiffness is not None:
        off = off + rig.loads.of_payload / rig.background.stiffness
    for fault, scale in planted:
        if fault.turn_joints is not None:
            off = off + fault.turn_joints(scale)
    return off


def _turn_gravity(rig: Rig, planted: Sequence[Planted]) -> Array:
    """(3,) or (N, 3), m/s^2, base axes."""
    by = np.broadcast_to(rig.background.tilt, (rig.steps, 3))
    for fault, scale in planted:
        if fault.turn_gravity is not None:
            by = by + fault.turn_gravity(scale)
    if np.ptp(by, axis=0).max() < 1e-12:
        return np.asarray(rotate_by_vector(by[0]) @ GRAVITY)
    return turn_vector(GRAVITY, by)
