"""A lag for each joint, against the wrench of point masses on joints that are that far ahead."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import least_squares

from core.effects.kinematic_lag import KinematicLag
from core.effects.lag_of_each_joint import LagOfEachJoint
from tests.core.effects.mechanical_truth import SIGMA, Array, believed, change, rms, scene, truth, without_nuisance

EFFECT = LagOfEachJoint()
STARTED = slice(10, None)
"""Rows from which on derivatives are known: this run begins in motion, which no recording does."""
LAGS = np.array([0.0, 0.006, 0.011, 0.017, 0.022, 0.028, 0.033])


def ahead(t: Array) -> Array:
    """(N, 7), true joints where each recorded one is late by its lag."""
    return np.column_stack([believed(t + lag)[:, j] for j, lag in enumerate(LAGS)])


def test_it_does_to_the_wrench_what_joints_do_that_are_ahead_of_their_record() -> None:
    true = truth(ahead).wrench() - truth().wrench()
    assert rms(true) > 0.3, "nothing was planted"
    assert rms((change(EFFECT, LAGS) - true)[STARTED]) < 0.04 * rms(true[STARTED])
    assert rms((change(EFFECT, 0.1 * LAGS) - 0.1 * true)[STARTED]) < 0.04 * rms(0.1 * true[STARTED])


def test_one_lag_for_all_is_the_plain_effect() -> None:
    run = scene()
    plain = KinematicLag().wrench(run, run.nominal, np.array([0.02]))
    np.testing.assert_allclose(EFFECT.wrench(run, run.nominal, np.full(7, 0.02)), plain, atol=1e-12)


def test_a_fit_beside_the_plain_lag_finds_each() -> None:
    noise = np.random.default_rng(1).normal(size=scene().nominal.shape)
    planted = truth(ahead).wrench() - truth().wrench()
    planted[: STARTED.start] = change(EFFECT, LAGS)[: STARTED.start]
    residual = without_nuisance((planted / SIGMA + noise).ravel())
    assert EFFECT.starts(scene(), residual.reshape(-1, 6)) == []
    (start,) = EFFECT.starts_beside(scene(), residual.reshape(-1, 6), np.array([0.015]))
    fit = least_squares(lambda x: residual - without_nuisance((change(EFFECT, x) / SIGMA).ravel()), start, x_scale=0.01)
    # the first joint is vertical: its lag turns nothing against gravity
    np.testing.assert_allclose(fit.x[1:], LAGS[1:], atol=2e-3)
    assert 2.0 * fit.cost < 1.05 * residual.size


def test_without_joints_there_is_none_and_the_advice_has_the_worst_and_the_best() -> None:
    assert EFFECT.explain_absence(replace(scene(), q=None, dq=None, jacobian=None)) is not None
    assert EFFECT.explain_absence(scene()) is None
    said = EFFECT.advice(scene(), LAGS).text
    assert "joint 7 is 33.0 ms late" in said
    assert "0.0 ms" in said
