"""Zeros that creep, against the wrench of point masses on joints that creep so."""

from __future__ import annotations

import numpy as np
from scipy.optimize import least_squares

from core.effects.joint_offset import JointOffset
from core.effects.zeros_that_warm_up import ZerosThatWarmUp
from tests.core.effects.mechanical_truth import SIGMA, Array, T, believed, change, rms, scene, truth, without_nuisance

EFFECT = ZerosThatWarmUp()
ZEROS = np.array([0.0, 0.004, -0.003, 0.005, 0.002, -0.004, 0.003])
GROWN = np.array([0.0, 0.010, 0.012, -0.009, 0.008, 0.011, -0.012])
RATE = 0.1
THETA = np.concatenate((ZEROS, GROWN, [RATE]))


def creeping(t: Array) -> Array:
    """(N, 7): off by ZEROS at first, by GROWN more after a minute."""
    grown = (1.0 - np.exp(-RATE * t)) / (1.0 - np.exp(-RATE * 60.0))
    return believed(t) + ZEROS + grown[:, None] * GROWN


def test_it_does_to_the_wrench_what_joints_do_whose_zeros_creep() -> None:
    true = truth(creeping).wrench() - truth().wrench()
    assert rms(true) > 0.3, "nothing was planted"
    assert rms(change(EFFECT, THETA) - true) < 0.01 * rms(true)


def test_zeros_that_stay_are_the_plain_effect() -> None:
    plain = change(JointOffset(), np.concatenate((ZEROS, np.zeros(14))))
    np.testing.assert_allclose(change(EFFECT, np.concatenate((ZEROS, np.zeros(7), [RATE]))), plain, atol=1e-12)


def test_a_fit_beside_zeros_that_stay_finds_how_they_creep() -> None:
    noise = np.random.default_rng(2).normal(size=scene().nominal.shape)
    residual = without_nuisance(((truth(creeping).wrench() - truth().wrench()) / SIGMA + noise).ravel())
    assert EFFECT.starts(scene(), residual.reshape(-1, 6)) == []
    scale = np.array([p.scale for p in EFFECT.parameters(scene())])

    def left(x: Array) -> Array:
        return residual - without_nuisance((change(EFFECT, x) / SIGMA).ravel())

    starts = EFFECT.starts_beside(scene(), residual.reshape(-1, 6), np.concatenate((ZEROS + 0.6 * GROWN, np.zeros(14))))
    fit = min((least_squares(left, start, x_scale=scale) for start in starts), key=lambda each: each.cost)
    assert 2.0 * fit.cost < 1.05 * residual.size
    at_end = (1.0 - np.exp(-fit.x[-1] * T[-1])) / (1.0 - np.exp(-fit.x[-1] * 60.0)) * fit.x[7:14]
    true = (1.0 - np.exp(-RATE * T[-1])) / (1.0 - np.exp(-RATE * 60.0)) * GROWN
    np.testing.assert_allclose(at_end[1:], true[1:], atol=1.5e-3)


def test_the_advice_has_the_joint_that_creeps_most() -> None:
    said = EFFECT.advice(scene(), THETA).text
    assert "joint 3" in said
    assert "0.63 deg within 24 s" in said
