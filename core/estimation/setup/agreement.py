"""Whether the numbers that a fit has found several ways agree: `z = M theta` with theta = (m, mc) or more, M of ones if all is right."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.estimation.setup.payload_fit import MASS_INERTIA, MASS_WEIGHT, MOMENT_FORCE, MOMENT_INERTIA, MOMENT_WEIGHT, PayloadFit

SIZE = 11
SLACK = 0.06
"""Share of each number that delays, filters, gains and windows may take without blame."""
BLURRED = 3.0
"""Times the share of noise in an acceleration that its coefficient may be too small by."""
LEVER_M = 0.02
"""Slack of the first moment as a distance."""


def measure_disagreement(fit: PayloadFit, M: Array | None = None) -> float:
    """Chi-square of what M (11, k) leaves of the numbers, slack allowed; about 7 where a right set-up is what it says."""
    covariance = _covariance(fit)
    scale = 1.0 / np.sqrt(np.diag(covariance))
    root = np.linalg.cholesky(covariance * np.outer(scale, scale))
    A = np.linalg.solve(root, (relate() if M is None else M) * scale[:, None])
    b = np.linalg.solve(root, fit.z[:SIZE] * scale)
    x, *_ = np.linalg.lstsq(A, b, rcond=1e-12)
    return float(((b - A @ x) ** 2).sum())


def relate(weight: float = 1.0, inertia: float = 1.0, moments: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> Array:
    """M (11, 4) of factors on m_w, m_a, and mc_w, mc_a, mc_f."""
    M = np.zeros((SIZE, 4))
    M[MASS_WEIGHT, 0], M[MASS_INERTIA, 0] = weight, inertia
    for part, factor in zip((MOMENT_WEIGHT, MOMENT_INERTIA, MOMENT_FORCE), moments, strict=True):
        M[part, 1:] = factor * np.eye(3)
    return M


def _covariance(fit: PayloadFit) -> Array:
    slack = SLACK * np.abs(fit.z[:SIZE])
    slack[[MASS_WEIGHT, MASS_INERTIA]] += 1e-3
    for part in (MOMENT_WEIGHT, MOMENT_INERTIA, MOMENT_FORCE):
        slack[part] = SLACK * np.linalg.norm(fit.z[part]) + LEVER_M * SLACK * abs(fit.mass) + 1e-4
    linear, turning = BLURRED * np.array(fit.blur)
    slack[MASS_INERTIA] += linear * abs(fit.mass)
    slack[MOMENT_INERTIA] += linear * np.linalg.norm(fit.first_moment)
    slack[MOMENT_FORCE] += turning * np.linalg.norm(fit.first_moment)
    return fit.covariance[:SIZE, :SIZE] + np.diag(slack**2)
