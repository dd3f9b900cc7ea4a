"""The paper's uncertainties, Eq. (8)-(10), with the slips of the print corrected."""

from __future__ import annotations

import numpy as np

from core.array import Array


def gain(covariance: Array, regr: Array, variance: Array) -> Array:
    """(n, r), the gain of the recursion: `S r^T (r S r^T + L)^-1`.

    Args:
        covariance: S_{k-1} (n, n).
        regr: (r, n).
        variance: diagonal of Lambda (r,), of the sensor's samples.
    """
    rS = regr @ covariance
    innovation = rS @ regr.T
    innovation.flat[:: len(variance) + 1] += variance
    return np.asarray(np.linalg.solve(innovation, rS).T)


def propagate_covariance(covariance: Array, regr: Array, K: Array) -> Array:
    """Eq. (8): `S_k = [1 - S_{k-1} r^T (r S_{k-1} r^T + L)^-1 r] S_{k-1}` with the gain K; the print lacks the inverse and the last factor.

    Made symmetric again, which rounding would undo over many thousand samples.
    """
    S = covariance - K @ (regr @ covariance)
    return 0.5 * (S + S.T)


def one_sigma(covariance: Array) -> Array:
    """Eq. (9): square roots of the diagonal."""
    return np.asarray(np.sqrt(np.diag(covariance)))


def inertia_uncertainty(inertia: float, *, torque_std: float, alpha_std: float, alpha_reference: float) -> float:
    """Eq. (10), kg m2, for one moment of inertia.

    The identified inertia stands where the paper has the one from CAD, which a user does not have.

    Args:
        inertia: identified, kg m2.
        torque_std: of one sample, N m.
        alpha_std: of the angular acceleration's estimate, rad/s2.
        alpha_reference: acceleration of the motion, rad/s2.
    """
    torque_reference = inertia * alpha_reference
    return abs(inertia) * float(np.hypot(torque_std / torque_reference, alpha_std / alpha_reference))
