"""An estimate that the recording's own poses contradict is none, however certain it is of itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.estimation.estimate import Estimate
from core.estimation.setup.payload_fit import MOMENT_WEIGHT, PayloadFit
from core.estimation.setup.search import BAD
from core.payload.inertia import PHI_NAMES
from core.words.message import Message

TOLERATED = 0.1
"""Share of the weight by which the simple model and the estimate may differ: what drift, delay and cross-talk do to the simple one."""
TOLERATED_M = 0.02
"""The same of the centre of mass."""
SIGMAS = 6.0


def refute(estimate: Estimate, poses: PayloadFit | None) -> Estimate:
    """The estimate as it is; or with nothing determined, where mass or first moment are not what the weight in the poses says.

    Args:
        poses: the simple model; it says nothing where it does not fit, or does not see the mass.
    """
    if poses is None or poses.misfit > BAD or not poses.upright or not estimate.determined[0]:
        return estimate
    mass, std = float(estimate.phi[0]), float(np.hypot(estimate.std[0], poses.mass_std))
    moment = estimate.phi[1:4] - poses.first_moment
    moment_std = np.hypot(estimate.std[1:4], np.sqrt(np.diag(poses.covariance)[MOMENT_WEIGHT]))
    lever = TOLERATED * poses.lever_m + TOLERATED_M
    heavy = abs(mass - poses.mass) > TOLERATED * poses.mass + SIGMAS * std
    elsewhere = bool((np.abs(moment) > lever * poses.mass + SIGMAS * moment_std)[np.isfinite(moment)].any())
    if not (heavy or elsewhere):
        return estimate
    why = Message.of("setup-poses-contradict", mass_kg=mass, weighed_kg=poses.mass)
    unknown = np.full(10, np.nan)
    return replace(
        estimate,
        phi=unknown,
        covariance=np.full((10, 10), np.nan),
        determined=np.zeros(10, dtype=bool),
        reasons=dict.fromkeys(PHI_NAMES, why),
    )
