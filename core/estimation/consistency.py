"""The nearest payload that can exist: parameters whose pseudo-inertia is positive definite."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.payload.inertia import is_consistent, phi_of_pseudo_inertia, pseudo_inertia

SMALLEST = 1e-6
"""Eigenvalue of the scaled pseudo-inertia that is kept: a body is never quite flat."""
SIZE_M = 0.05
NO_SUCH_BODY = 11.34
"""Squared distance from what can exist beyond which no body explains the data: the 99 % point of chi-square with three degrees of freedom.
A rod is where this matters most: there the edge of what can exist has three directions to leave it by. A body that can exist is called
impossible in one of a hundred recordings at most, and any but a plate or a rod next to never."""
ROUNDING = 1e-13


def nearest_consistent(phi: Array, covariance: Array) -> Array:
    """The parameters (10,) that a body can have and that are nearest to phi in the metric of its covariance (10, 10).

    phi itself where it is consistent. Otherwise the problem is solved over `P = S (L L^T + SMALLEST 1) S`, S a scale: any L is
    allowed, so that no constraint is left, and the best body may lie on the edge of what can exist. L has all sixteen entries: with a
    triangle of them rods would end in minima that are none of the convex problem (Burer and Monteiro 2005, Math. Program. 103).
    """
    if is_consistent(phi):
        return phi
    from scipy.optimize import least_squares  # noqa: PLC0415 - most payloads are consistent and wait for no optimiser

    root = _inverse_root(covariance)
    mass = max(float(phi[0]), 1e-4)
    scale = np.sqrt(mass) * np.array([SIZE_M, SIZE_M, SIZE_M, 1.0])
    start = _positive_part(pseudo_inertia(phi) / np.outer(scale, scale))

    def body(entries: Array) -> Array:
        L = entries.reshape(4, 4)
        return phi_of_pseudo_inertia((L @ L.T + SMALLEST * np.eye(4)) * np.outer(scale, scale))

    def distance(entries: Array) -> Array:
        return np.asarray(root @ (body(entries) - phi))

    def slope(entries: Array) -> Array:
        L = entries.reshape(4, 4)
        columns = []
        for i, j in np.ndindex(4, 4):
            E = np.zeros((4, 4))
            E[i] = L[:, j]
            columns.append(phi_of_pseudo_inertia((E + E.T) * np.outer(scale, scale)))
        return np.asarray(root @ np.column_stack(columns))

    first = np.linalg.cholesky(start).ravel()
    solution = least_squares(distance, first, jac=slope, x_scale="jac", xtol=1e-10, ftol=1e-10, gtol=1e-10, max_nfev=200)
    return body(solution.x)


def distance_from_bodies(phi: Array, body: Array, covariance: Array) -> float:
    """Squared distance of phi (10,) from the nearest body (10,), in the metric of the covariance (10, 10); against `NO_SUCH_BODY`."""
    away = _inverse_root(covariance) @ (phi - body)
    return float(away @ away)


def _positive_part(P: Array) -> Array:
    values, vectors = np.linalg.eigh(P)
    return np.asarray((vectors * np.maximum(values, 1e-2)) @ vectors.T)


def _inverse_root(covariance: Array) -> Array:
    """R (10, 10) with R S R^T = 1; a direction without any uncertainty is taken as nearly certain."""
    scale = np.sqrt(np.diag(covariance))
    values, vectors = np.linalg.eigh(covariance / np.outer(scale, scale))
    return np.asarray((vectors / np.sqrt(np.maximum(values, ROUNDING * values[-1]))).T / scale)
