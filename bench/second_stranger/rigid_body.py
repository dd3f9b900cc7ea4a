"""The wrench that a rigid payload asks of the sensor, by the specification's Eq. (1), and what moved parts and pushes add to it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rotations import find_cross_matrix
from bench.second_stranger.signals import derive


@dataclass(frozen=True)
class Body:
    """A payload: kg, centre of mass (3,) in m and inertia about it (3, 3) in kg m^2, sensor axes."""

    mass: float
    com: Array
    inertia_at_com: Array

    @property
    def first_moment(self) -> Array:
        """(3,), kg m."""
        return np.asarray(self.mass * self.com)

    @property
    def inertia(self) -> Array:
        """(3, 3), kg m^2, about the sensor's origin."""
        S = find_cross_matrix(self.com)
        return np.asarray(self.inertia_at_com - self.mass * S @ S)


def find_wrench(k: Kinematics, mass: float, first_moment: Array, inertia: Array) -> Array:
    """(N, 6), force in N and torque in N m, sensor axes, as the sensor reads it: at rest with x along gravity fx is -m g.

    Args:
        mass: kg.
        first_moment: (3,), kg m, sensor axes.
        inertia: (3, 3), kg m^2, about the sensor's origin.
    """
    f = mass * k.u + np.cross(k.alpha, first_moment) + np.cross(k.omega, np.cross(k.omega, first_moment))
    t = np.cross(first_moment, k.u) + k.alpha @ inertia.T + np.cross(k.omega, k.omega @ inertia.T)
    return np.hstack([f, t])


def find_body_wrench(k: Kinematics, body: Body) -> Array:
    """(N, 6), N and N m, sensor axes."""
    return find_wrench(k, body.mass, body.first_moment, body.inertia)


def find_regressor(k: Kinematics) -> Array:
    """(N, 6, 10), by which mass, first moment and inertia (xx, xy, xz, yy, yz, zz) make the wrench."""
    Y = np.zeros((len(k.u), 6, 10))
    for i, e in enumerate(np.eye(10)):
        inertia = np.array([[e[4], e[5], e[6]], [e[5], e[7], e[8]], [e[6], e[8], e[9]]])
        Y[:, :, i] = find_wrench(k, e[0], e[1:4], inertia)
    return Y


def find_point_wrench(k: Kinematics, at: Array) -> Array:
    """(N, 6), N and N m for each kg of a point mass at a place (3,), m."""
    f = k.feel_at(at)
    return np.hstack([f, np.cross(at, f)])


def find_moved_part_wrench(k: Kinematics, mass: float, rest: Array, by: Array) -> Array:
    """(N, 6), N and N m: what a point part in kg, whose place at rest (3,) belongs to the payload, asks for beyond that when it is moved
    by (N, 3), m; all in sensor axes."""
    speed, acceleration = derive(by), derive(derive(by))
    f = mass * (k.feel_at(rest + by) + acceleration + 2 * np.cross(k.omega, speed))
    at_rest = mass * k.feel_at(rest)
    return np.hstack([f - at_rest, np.cross(rest + by, f) - np.cross(rest, at_rest)])


def push(W: Array, k: Kinematics, force: Array, at: Array) -> Array:
    """(N, 6), the wrench W with forces (N, 3), N, base axes, of the surroundings on the payload at a place (3,), m, sensor axes."""
    f = k.turn_into_sensor(force)
    return np.asarray(W - np.hstack([f, np.cross(at, f)]))
