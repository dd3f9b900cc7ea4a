"""An estimate that the poses contradict is none."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.budget import Budget
from core.estimation.estimate import DriftEstimate, Estimate
from core.estimation.setup.payload_fit import COUNT, MASS_WEIGHT, MOMENT_WEIGHT, PayloadFit
from core.estimation.setup.refutation import refute

NONE = np.zeros(6)


def weighed(mass: float, misfit: float = 1.0) -> PayloadFit:
    z = np.zeros(COUNT)
    z[MASS_WEIGHT], z[MOMENT_WEIGHT] = mass, [0.0, 0.0, 0.1 * mass]
    return PayloadFit(z, 1e-8 * np.eye(COUNT), misfit, (0.02, 0.02), 100, (0.0, 0.0))


def estimated(mass: float, lever_m: float = 0.1) -> Estimate:
    phi = np.array([mass, 0.0, 0.0, lever_m * mass, 0.02, 0.0, 0.0, 0.02, 0.0, 0.01])
    drift = DriftEstimate(np.zeros(0), np.zeros((0, 6)), NONE)
    alone = Budget(1e-8 * np.eye(10), ())
    return Estimate(phi, alone.repeatability, np.ones(10, dtype=bool), {}, NONE, NONE, True, NONE, NONE, drift, budget=alone)


@pytest.mark.parametrize(("mass", "lever_m"), [(2.0, 0.1), (2.15, 0.1), (2.0, 0.12)])
def test_what_is_near_enough_stays_as_it_is(mass: float, lever_m: float) -> None:
    estimate = estimated(mass, lever_m)
    assert refute(estimate, weighed(2.0)) is estimate


@pytest.mark.parametrize(("mass", "lever_m"), [(1.6, 0.1), (2.4, 0.1), (2.0, 0.2)])
def test_what_is_not_is_not_determined_and_says_both_masses(mass: float, lever_m: float) -> None:
    refuted = refute(estimated(mass, lever_m), weighed(2.0))
    assert not refuted.determined.any() and np.isnan(refuted.phi).all() and np.isnan(refuted.covariance).all()
    assert refuted.reasons["m"].parameters == {"mass_kg": mass, "weighed_kg": 2.0}


def test_poses_that_do_not_fit_themselves_contradict_nothing() -> None:
    estimate = estimated(1.0)
    assert refute(estimate, weighed(2.0, misfit=20.0)) is estimate
    assert refute(estimate, None) is estimate
