"""How the sensor moves when the joints do, and what gravity asks of the joints; for all samples at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bench.stranger.arms import Arm
from bench.stranger.array import Array
from bench.stranger.rotations import rotate_by_rpy, rotate_by_vector


@dataclass(frozen=True)
class Felt:
    """What a body on the sensor feels of the motion, over N samples; sensor axes.

    Attributes:
        omega, alpha: (N, 3), rad/s and rad/s^2.
        u: (N, 3), acceleration of the sensor's origin less gravity, m/s^2.
        g: (N, 3), gravity, m/s^2.
    """

    omega: Array
    alpha: Array
    u: Array
    g: Array


@dataclass(frozen=True)
class Kinematics(Felt):
    """The sensor's frame over N samples.

    Attributes:
        R: (N, 3, 3), from sensor axes to base axes.
        p, v: (N, 3), place and speed of its origin, m and m/s, base axes.
    """

    R: Array
    p: Array
    v: Array

    def find_place(self, point: Array) -> Array:
        """(N, 3), m, base axes: where a point (3,), m, sensor axes, is."""
        return np.asarray(self.p + np.einsum("nij,j->ni", self.R, point))

    def turn_into_sensor(self, v: Array) -> Array:
        """(N, 3), sensor axes, of vectors (N, 3) or (3,), base axes."""
        return np.asarray(np.einsum("nji,nj->ni", self.R, np.broadcast_to(v, (len(self.R), 3))))


@dataclass(frozen=True)
class Loads:
    """What gravity asks of the joints.

    Attributes:
        of_payload, of_all: (N, n), N m, about the joints' axes: of the payload alone, and of links and payload.
        overturning: (N, 3), N m, base axes: the moment of links and payload about the base's origin.
    """

    of_payload: Array
    of_all: Array
    overturning: Array


def move_arm(
    arm: Arm,
    q: Array,
    dq: Array,
    ddq: Array,
    gravity: Array,
    base_acceleration: Array | None = None,
    mounting: Array | None = None,
) -> Kinematics:
    """Follows the chain from the base to the sensor.

    Args:
        q, dq, ddq: (N, n), rad and its derivatives by s.
        gravity: (3,) or (N, 3), m/s^2, base axes.
        base_acceleration: (N, 3), m/s^2, base axes.
        mounting: (3,), rotation vector in rad by which the sensor is turned in its own axes.
    """
    N = len(q)
    g = np.broadcast_to(np.asarray(gravity, float), (N, 3))
    R = np.broadcast_to(np.eye(3), (N, 3, 3))
    p, v, a, omega, alpha = (np.zeros((N, 3)) for _ in range(5))
    for i, joint in enumerate(arm.joints):
        p, v, a = _step_along(R @ np.asarray(joint.xyz, float), p, v, a, omega, alpha)
        R = R @ rotate_by_rpy(joint.rpy)
        z = R[:, :, 2]
        alpha = alpha + z * ddq[:, i : i + 1] + np.cross(omega, z) * dq[:, i : i + 1]
        omega = omega + z * dq[:, i : i + 1]
        R = _turn_about_z(R, q[:, i])
    p, v, a = _step_along(R @ np.asarray(arm.sensor_xyz, float), p, v, a, omega, alpha)
    mount = rotate_by_rpy(arm.sensor_rpy)
    R = R @ (mount if mounting is None else mount @ rotate_by_vector(mounting))
    if base_acceleration is not None:
        a = a + base_acceleration
    Rt = np.transpose(R, (0, 2, 1))
    omega, alpha, u, g = (np.asarray(np.einsum("nij,nj->ni", Rt, x)) for x in (omega, alpha, a - g, g))
    return Kinematics(omega, alpha, u, g, R, p, v)


def find_loads(arm: Arm, q: Array, gravity: Array, sensor: Kinematics, mass: float, com: Array) -> Loads:
    """Torques and moment that gravity makes of the links and of a payload.

    Args:
        q: (N, n), rad.
        gravity: (3,), m/s^2, base axes.
        sensor: where the sensor is at these joints.
        mass, com: the payload's, kg and (3,) m, sensor axes.
    """
    N, n = q.shape
    g = np.broadcast_to(gravity, (N, 3))
    R = np.broadcast_to(np.eye(3), (N, 3, 3))
    p = np.zeros((N, 3))
    axes, origins, coms = [], [], []
    for i, (joint, link) in enumerate(zip(arm.joints, arm.links, strict=True)):
        p = p + R @ np.asarray(joint.xyz, float)
        R = R @ rotate_by_rpy(joint.rpy)
        axes.append(R[:, :, 2])
        origins.append(p)
        R = _turn_about_z(R, q[:, i])
        coms.append(p + R @ np.asarray(link.com, float))
    of_links, of_payload = np.zeros((N, n)), np.zeros((N, n))
    carried = sensor.p + sensor.R @ com
    for i in range(n):
        of_payload[:, i] = np.einsum("ni,ni->n", np.cross(axes[i], carried - origins[i]), mass * g)
        for j in range(i, n):
            of_links[:, i] += np.einsum("ni,ni->n", np.cross(axes[i], coms[j] - origins[i]), arm.links[j].mass * g)
    overturning = np.cross(carried, mass * g)
    for link, place in zip(arm.links, coms, strict=True):
        overturning = overturning + np.cross(place, link.mass * g)
    return Loads(of_payload, of_links + of_payload, np.asarray(overturning))


def _step_along(d: Array, p: Array, v: Array, a: Array, omega: Array, alpha: Array) -> tuple[Array, Array, Array]:
    """Place, speed and acceleration (N, 3) of a point that is d (N, 3) further on the same link, base axes."""
    turning = np.cross(omega, d)
    return p + d, v + turning, a + np.cross(alpha, d) + np.cross(omega, turning)


def _turn_about_z(R: Array, angle: Array) -> Array:
    """(N, 3, 3), turned by angles (N,) in rad about their own z."""
    c, s = np.cos(angle)[:, None], np.sin(angle)[:, None]
    return np.stack([R[:, :, 0] * c + R[:, :, 1] * s, -R[:, :, 0] * s + R[:, :, 1] * c, R[:, :, 2]], axis=2)
