"""Mass, first moment and offsets from the motionless poses so far, opposed or not: what can be said before the paper's method can."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.payload.inertia import Motion, regressor

PRIOR_STD = np.concatenate(([30.0], np.full(3, 3.0), np.full(6, 1e3)))
"""Of mass (kg), first moment (kg m) and offsets (N, N m): so wide that they matter only where no pose has told anything."""
KNOWN_SHARE = 0.01
"""Of the prior; what is less certain is not known yet."""
_OF_GRAVITY = regressor(Motion.still(np.eye(3)))[:, :, :4]
"""(3, 6, 4): the regressor of a motionless payload, which is linear in gravity."""


class StillPoses:
    """Recursive weighted least squares over motionless samples.

    Args:
        noise_std: (6,), of one sample, N and N m.
    """

    def __init__(self, noise_std: Array) -> None:
        self._weight = noise_std**-2.0
        self._normal = np.diag(PRIOR_STD**-2.0)
        self._right = np.zeros(10)
        self._columns = np.concatenate((np.zeros((6, 4)), np.eye(6)), axis=1)

    def add(self, g: Array, wrench: Array) -> None:
        """Takes one motionless sample: gravity (3,) in the sensor frame and the raw wrench (6,)."""
        self._columns[:, :4] = (g @ _OF_GRAVITY.reshape(3, 24)).reshape(6, 4)
        weighted = self._columns.T * self._weight
        self._normal += weighted @ self._columns
        self._right += weighted @ wrench

    @property
    def found(self) -> tuple[Array, Array]:
        """Mass, first moment, offsets and their standard uncertainties, (10,) each; NaN where the poses have not told yet."""
        scale = 1.0 / np.sqrt(np.diag(self._normal))
        covariance = np.linalg.inv(self._normal * np.outer(scale, scale)) * np.outer(scale, scale)
        std = np.sqrt(np.diag(covariance))
        known = std < KNOWN_SHARE * PRIOR_STD
        return np.where(known, covariance @ self._right, np.nan), np.where(known, std, np.nan)
