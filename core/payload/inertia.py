"""Inertial parameters of a rigid payload, the regressor of Eq. (2), and frame changes that carry the covariance along.

Order of Phi as in the paper: `[m, mc_x, mc_y, mc_z, Ixx, Ixy, Ixz, Iyy, Iyz, Izz]`, sensor frame, inertia about the sensor origin.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from core.array import Array
from core.errors import BadPayload
from core.payload.rotations import skew

PHI_NAMES = ("m", "mc_x", "mc_y", "mc_z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")
PHI_UNITS = ("kg", "kg m", "kg m", "kg m", *["kg m2"] * 6)

# Pinocchio's order is [m, mc, Ixx, Ixy, Iyy, Ixz, Iyz, Izz]. The permutation is its own inverse; this is the only place that knows it.
PINOCCHIO_ORDER = np.array([0, 1, 2, 3, 4, 5, 7, 6, 8, 9])

_ROW = np.array([0, 0, 0, 1, 1, 2])
_COLUMN = np.array([0, 1, 2, 1, 2, 2])


def symmetric(six: ArrayLike) -> Array:
    """3x3 symmetric matrix from `[xx, xy, xz, yy, yz, zz]`; leading dimensions are kept."""
    six = np.asarray(six, dtype=float)
    matrix = np.empty((*six.shape[:-1], 3, 3))
    matrix[..., _ROW, _COLUMN] = six
    matrix[..., _COLUMN, _ROW] = six
    return matrix


def six_of(matrix: Array) -> Array:
    """`[xx, xy, xz, yy, yz, zz]` of a symmetric 3x3 matrix; leading dimensions are kept."""
    return np.asarray(matrix[..., _ROW, _COLUMN])


@dataclass(frozen=True)
class InertialParameters:
    """The ten inertial parameters of a rigid body in one frame, SI.

    Args:
        phi: shape (10,), the paper's order; inertia about the frame's origin.
    """

    phi: Array

    def __post_init__(self) -> None:
        phi = np.array(self.phi, dtype=float)
        if phi.shape != (10,) or not np.isfinite(phi).all():
            raise BadPayload("phi", "payload-not-ten-numbers", values=[f"{value:g}" for value in phi.ravel()[:12]], names=PHI_NAMES)
        phi.flags.writeable = False
        object.__setattr__(self, "phi", phi)

    @classmethod
    def from_com(cls, mass: float, com: ArrayLike, inertia_com: ArrayLike) -> InertialParameters:
        """From mass, centre of mass (3,) and the 3x3 inertia about it (parallel-axis theorem)."""
        c = np.asarray(com, dtype=float)
        inertia = np.asarray(inertia_com, dtype=float) + mass * (c @ c * np.eye(3) - np.outer(c, c))
        return cls(np.concatenate(([mass], mass * c, six_of(inertia))))

    @property
    def mass(self) -> float:
        """kg."""
        return float(self.phi[0])

    @property
    def first_moment(self) -> Array:
        """m c, shape (3,), kg m."""
        return self.phi[1:4]

    @property
    def inertia(self) -> Array:
        """3x3 inertia about the frame's origin, kg m2."""
        return symmetric(self.phi[4:])

    @property
    def com(self) -> Array:
        """Centre of mass, shape (3,), m; NaN for a massless body."""
        return self.first_moment / self.mass if self.mass > 0 else np.full(3, np.nan)

    @property
    def inertia_com(self) -> Array:
        """3x3 inertia about the centre of mass, kg m2."""
        c = self.com
        return self.inertia - self.mass * (c @ c * np.eye(3) - np.outer(c, c))

    @cached_property
    def pseudo_inertia(self) -> Array:
        """The 4x4 matrix `[[tr(I)/2 1 - I, mc], [mc^T, m]]`, positive definite for every real body (Wensing et al. 2018)."""
        return pseudo_inertia(self.phi)

    @property
    def consistent(self) -> bool:
        """Whether a real body, with positive density somewhere, can have these parameters."""
        return is_consistent(self.phi)

    def to_frame(self, rotation: ArrayLike, translation: ArrayLike) -> InertialParameters:
        """The same body in another frame; see `frame_change`."""
        return InertialParameters(frame_change(rotation, translation) @ self.phi)


def pseudo_inertia(phi: Array) -> Array:
    """4x4 pseudo-inertia of parameters (10,)."""
    inertia = symmetric(phi[4:])
    P = np.empty((4, 4))
    P[:3, :3] = 0.5 * np.trace(inertia) * np.eye(3) - inertia
    P[:3, 3] = P[3, :3] = phi[1:4]
    P[3, 3] = phi[0]
    return P


def phi_of_pseudo_inertia(P: Array) -> Array:
    """Inverse of `pseudo_inertia`, shape (10,)."""
    second = P[:3, :3]
    inertia = np.trace(second) * np.eye(3) - second
    return np.concatenate(([P[3, 3]], P[:3, 3], six_of(inertia)))


def is_consistent(phi: Array) -> bool:
    """Whether the pseudo-inertia is positive definite, judged after scaling so that kilograms and kg m2 weigh alike."""
    P = pseudo_inertia(phi)
    d = np.diag(P)
    if not (d > 0).all():
        return False
    scale = 1.0 / np.sqrt(d)
    return bool(np.linalg.eigvalsh(P * np.outer(scale, scale))[0] > 0.0)


def frame_change(rotation: ArrayLike, translation: ArrayLike) -> Array:
    """Matrix A (10, 10) with `phi_new = A phi_old`; a covariance moves as `A Sigma A^T`.

    Args:
        rotation: (3, 3), turns coordinates of the old frame into the new one.
        translation: (3,), origin of the old frame in the new one, m.
    """
    T = np.eye(4)
    T[:3, :3] = rotation
    T[:3, 3] = translation
    return np.column_stack([phi_of_pseudo_inertia(T @ pseudo_inertia(unit) @ T.T) for unit in np.eye(10)])


@dataclass(frozen=True)
class Motion:
    """Kinematics in the sensor frame; one row per sample, SI. The existence of a Motion means that kinematics are known.

    Args:
        g: gravity, (N, 3).
        a: linear acceleration of the sensor origin (without gravity), (N, 3).
        omega: angular velocity, (N, 3).
        alpha: angular acceleration, (N, 3).
    """

    g: Array
    a: Array
    omega: Array
    alpha: Array

    def __len__(self) -> int:
        return len(self.g)

    def __getitem__(self, rows: slice | NDArray[np.bool_] | NDArray[np.intp]) -> Motion:
        return Motion(self.g[rows], self.a[rows], self.omega[rows], self.alpha[rows])

    @classmethod
    def still(cls, g: Array) -> Motion:
        """Motionless with the given gravity directions (N, 3)."""
        zero = np.zeros_like(g)
        return cls(g, zero, zero, zero)


def inertia_columns(v: Array) -> Array:
    """Matrix L (..., 3, 6) with `I v = L [Ixx, Ixy, Ixz, Iyy, Iyz, Izz]`."""
    L = np.zeros((*v.shape[:-1], 3, 6))
    x, y, z = v[..., 0], v[..., 1], v[..., 2]
    L[..., 0, 0], L[..., 0, 1], L[..., 0, 2] = x, y, z
    L[..., 1, 1], L[..., 1, 3], L[..., 1, 4] = x, y, z
    L[..., 2, 2], L[..., 2, 4], L[..., 2, 5] = x, y, z
    return L


def regressor(motion: Motion) -> Array:
    """V of Eq. (2), shape (N, 6, 10): `[f; tau] = V phi`, written out of Eq. (1)."""
    V = np.zeros((len(motion), 6, 10))
    b = motion.a - motion.g
    W = skew(motion.omega)
    V[:, :3, 0] = b
    V[:, :3, 1:4] = skew(motion.alpha) + W @ W
    V[:, 3:, 1:4] = -skew(b)
    V[:, 3:, 4:] = inertia_columns(motion.alpha) + W @ inertia_columns(motion.omega)
    return V


def spatial_inertia(phi: Array) -> Array:
    """(6, 6): wrench per linear and angular acceleration, the derivative of Eq. (1)."""
    S = skew(phi[1:4])
    return np.block([[phi[0] * np.eye(3), -S], [S, symmetric(phi[4:])]])
