"""How the sensor moves when the joints do, for all samples at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bench.second_stranger.arms import Arm
from bench.second_stranger.array import Array
from bench.second_stranger.rotations import rotate_by_vector


class JointMotion(NamedTuple):
    """Angles of the joints and their derivatives, each (N, n), rad and s."""

    q: Array
    dq: Array
    ddq: Array


class BaseTurn(NamedTuple):
    """By which the base is turned about its own z, and its derivatives, each (N,), rad and s."""

    angle: Array
    rate: Array
    acceleration: Array


@dataclass(frozen=True)
class Kinematics:
    """The sensor's frame over N samples.

    Attributes:
        R: (N, 3, 3), from sensor axes to base axes.
        p, v: (N, 3), place and speed of its origin, m and m/s, base axes.
        omega, alpha: (N, 3), rad/s and rad/s^2, sensor axes.
        u: (N, 3), acceleration of its origin less gravity, m/s^2, sensor axes.
    """

    R: Array
    p: Array
    v: Array
    omega: Array
    alpha: Array
    u: Array

    def turn_into_sensor(self, v: Array) -> Array:
        """(N, 3), sensor axes, of vectors (N, 3), base axes."""
        return _turn_back(self.R, v)

    def find_place(self, point: Array) -> Array:
        """(N, 3), m, base axes: where a point (3,), m, sensor axes, is."""
        return np.asarray(self.p + np.einsum("nij,j->ni", self.R, point))

    def find_speed(self, point: Array) -> Array:
        """(N, 3), m/s, base axes: how a point (3,), m, sensor axes, moves."""
        return np.asarray(self.v + np.einsum("nij,nj->ni", self.R, np.cross(self.omega, point)))

    def feel_at(self, point: Array) -> Array:
        """(N, 3), m/s^2, sensor axes: acceleration less gravity of a point (3,) or of places (N, 3), m, as if at rest on the sensor."""
        return np.asarray(self.u + np.cross(self.alpha, point) + np.cross(self.omega, np.cross(self.omega, point)))


def move_arm(
    arm: Arm,
    joints: JointMotion,
    gravity: Array,
    base: BaseTurn | None = None,
    turned: Array | None = None,
    moved: Array | None = None,
) -> Kinematics:
    """Follows the chain from the base to the sensor.

    Args:
        gravity: (N, 3), m/s^2, base axes.
        base: how the base turns, which gravity does not.
        turned: (3,), rotation vector in rad by which the sensor is turned in its own axes.
        moved: (3,), m, sensor axes, by which it is moved.
    """
    q, dq, ddq = joints
    N = len(q)
    R = np.tile(np.eye(3), (N, 1, 1))
    p, v, a, w, al = (np.zeros((N, 3)) for _ in range(5))
    if base is not None:
        R = _turn_about_z(R, base.angle)
        w[:, 2], al[:, 2] = base.rate, base.acceleration
    for i, (place, rotation) in enumerate(arm.list_steps()):
        r = R @ place
        turning = np.cross(w, r)
        p, v, a = p + r, v + turning, a + np.cross(al, r) + np.cross(w, turning)
        R = R @ rotation
        if i < arm.joint_count:
            z = R[:, :, 2]
            own = z * dq[:, i : i + 1]
            al = al + z * ddq[:, i : i + 1] + np.cross(w, own)
            w = w + own
            R = _turn_about_z(R, q[:, i])
    w, al, a = (_turn_back(R, x) for x in (w, al, a))
    if turned is not None:
        by = rotate_by_vector(turned)
        R, w, al, a = R @ by, w @ by, al @ by, a @ by
    if moved is not None:
        p = p + np.einsum("nij,j->ni", R, moved)
        a = a + np.cross(al, moved) + np.cross(w, np.cross(w, moved))
    return Kinematics(R, p, v, w, al, a - _turn_back(R, gravity))


def _turn_back(R: Array, v: Array) -> Array:
    """(N, 3), vectors (N, 3) turned by the inverse of R (N, 3, 3)."""
    return np.asarray(np.einsum("nij,ni->nj", R, v))


def _turn_about_z(R: Array, angle: Array) -> Array:
    """(N, 3, 3), turned by angles (N,) in rad about their own z."""
    c, s = np.cos(angle)[:, None], np.sin(angle)[:, None]
    return np.stack([c * R[:, :, 0] + s * R[:, :, 1], -s * R[:, :, 0] + c * R[:, :, 1], R[:, :, 2]], axis=2)
