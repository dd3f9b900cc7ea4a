"""The wrench that a rigid payload asks of the sensor, by the specification's Eq. (1), and the same as a linear map of its parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bench.stranger.array import Array
from bench.stranger.kinematics import Felt

SYMMETRIC = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
"""Places of xx, xy, xz, yy, yz, zz."""


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
        return self.inertia_at_com + find_steiner(self.mass, self.com)


def find_steiner(mass: float, at: Array) -> Array:
    """(3, 3), kg m^2, what a point mass at a place (3,), m, adds to the inertia about the origin."""
    return np.asarray(mass * (at @ at * np.eye(3) - np.outer(at, at)))


def find_wrench(k: Felt, mass: float | Array, first_moment: Array, inertia: Array) -> Array:
    """(N, 6), force in N and torque in N m, sensor axes, as the sensor reads it: at rest with x along gravity fx is -m g.

    Args:
        mass: kg, one number or (N,).
        first_moment: (3,) or (N, 3), kg m, sensor axes.
        inertia: (3, 3) or (N, 3, 3), kg m^2, about the sensor's origin.
    """
    N = len(k.u)
    m = np.broadcast_to(np.reshape(mass, (-1, 1)), (N, 1))
    mc = np.broadcast_to(first_moment, (N, 3))
    J = np.broadcast_to(inertia, (N, 3, 3))
    f = m * k.u + np.cross(k.alpha, mc) + np.cross(k.omega, np.cross(k.omega, mc))
    spin = np.einsum("nij,nj->ni", J, k.omega)
    t = np.cross(mc, k.u) + np.einsum("nij,nj->ni", J, k.alpha) + np.cross(k.omega, spin)
    return np.hstack([f, t])


def find_part_wrench(k: Felt, place: Array, acceleration: Array | float, mass: float) -> Array:
    """(N, 6), N and N m, of a point mass in kg at places (N, 3), m, that is accelerated by (N, 3), m/s^2, against the sensor; all in its
    axes."""
    f = mass * (k.u + acceleration)
    return np.hstack([f, np.cross(place, f)])


def read_push(force: Array, at: Array) -> Array:
    """(N, 6), N and N m: what the sensor reads of forces (N, 3) on the payload at a place (3,), m; all in sensor axes."""
    return -np.hstack([force, np.cross(np.broadcast_to(at, force.shape), force)])


def find_regressor(k: Felt) -> Array:
    """(N, 6, 16), by which mass, first moment, inertia (xx, xy, xz, yy, yz, zz) and six offsets make the wrench."""
    Y = np.zeros((len(k.u), 6, 16))
    nothing, none = np.zeros(3), np.zeros((3, 3))
    Y[:, :, 0] = find_wrench(k, 1.0, nothing, none)
    for i in range(3):
        Y[:, :, 1 + i] = find_wrench(k, 0.0, np.eye(3)[i], none)
    for n, (i, j) in enumerate(SYMMETRIC):
        one = none.copy()
        one[i, j] = one[j, i] = 1
        Y[:, :, 4 + n] = find_wrench(k, 0.0, nothing, one)
    for i in range(6):
        Y[:, i, 10 + i] = 1
    return Y
