"""Inertial parameters with their covariance: what follows from them, and how they look in another frame."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from core.array import Array
from core.payload.inertia import frame_change, six_of

ROUNDING = 1e-12  # of a frame change, whose entries are of the order of 1


@dataclass(frozen=True)
class UncertainParameters:
    """The ten parameters as far as they are known, SI.

    Args:
        phi: (10,), the paper's order; NaN where not determined.
        covariance: (10, 10), of `phi`; NaN in the rows and columns of what is not determined.
    """

    phi: Array
    covariance: Array

    @cached_property
    def std(self) -> Array:
        """(10,), standard uncertainty; NaN where not determined."""
        return roots_of_variances(self.covariance)

    @cached_property
    def com_m(self) -> Array:
        """(3,), centre of mass; NaN where not determined."""
        return np.asarray(self.phi[1:4] / self.phi[0])

    @cached_property
    def com_jacobian(self) -> Array:
        """(3, 10), change of the centre of mass with the parameters; NaN where not determined."""
        J = np.zeros((3, 10))
        J[:, :4] = np.column_stack((-self.com_m / self.phi[0], np.eye(3) / self.phi[0]))
        return J

    @cached_property
    def com_covariance(self) -> Array:
        """(3, 3), m2, by first-order propagation."""
        return propagate(self.com_jacobian, self.covariance)

    @property
    def com_std(self) -> Array:
        """(3,), m."""
        return roots_of_variances(self.com_covariance)

    @cached_property
    def inertia_com(self) -> Array:
        """(6,), `[Ixx, Ixy, Ixz, Iyy, Iyz, Izz]` about the centre of mass, kg m2; NaN where not determined."""
        return self.phi[4:] - six_of(_steiner(self.phi[:4]))

    @cached_property
    def inertia_com_jacobian(self) -> Array:
        """(6, 10), change of the inertia about the centre of mass with the parameters; NaN where not determined."""
        m, mc = self.phi[0], self.phi[1:4]
        J = np.zeros((6, 10))
        J[:, 4:] = np.eye(6)
        J[:, 0] = six_of(_steiner(self.phi[:4])) / m
        for i, e in enumerate(np.eye(3)):
            J[:, 1 + i] = -six_of(2.0 * mc[i] * np.eye(3) - np.outer(mc, e) - np.outer(e, mc)) / m
        return J

    @cached_property
    def inertia_com_std(self) -> Array:
        """(6,), kg m2, by first-order propagation."""
        return roots_of_variances(propagate(self.inertia_com_jacobian, self.covariance))

    def in_frame(self, rotation: ArrayLike, translation: ArrayLike) -> UncertainParameters:
        """The same body in another frame, arguments as of `core.payload.inertia.frame_change`; what mixes with unknowns is unknown."""
        A = frame_change(rotation, translation)
        A[np.abs(A) < ROUNDING] = 0.0
        known = np.isfinite(self.phi)
        phi = A[:, known] @ self.phi[known]
        phi[(A[:, ~known] != 0.0).any(axis=1)] = np.nan
        return UncertainParameters(phi, propagate(A, self.covariance))


def roots_of_variances(covariance: Array) -> Array:
    """(n,), standard uncertainties of (n, n); what cancels exactly may be below zero by rounding, and is zero."""
    return np.asarray(np.sqrt(np.maximum(np.diag(covariance), 0.0)))


def _steiner(moments: Array) -> Array:
    """3x3 share of the offset centre of mass in the inertia, from `[m, mc]`."""
    m, mc = moments[0], moments[1:]
    return np.asarray((mc @ mc * np.eye(3) - np.outer(mc, mc)) / m)


def propagate(J: Array, covariance: Array) -> Array:
    """J S J^T in which a NaN spoils only the outputs that depend on it."""
    unknown = np.isnan(np.diag(covariance))
    result = propagate_pair(J, covariance, J)
    spoilt = np.isnan(J).any(axis=1) | (np.abs(np.where(np.isnan(J), 1.0, J)) @ unknown > 0)
    result[spoilt, :] = np.nan
    result[:, spoilt] = np.nan
    return result


def propagate_pair(J: Array, covariance: Array, K: Array) -> Array:
    """J S K^T in which what is NaN counts as nothing."""
    return np.asarray(np.nan_to_num(J) @ np.nan_to_num(covariance) @ np.nan_to_num(K).T)
