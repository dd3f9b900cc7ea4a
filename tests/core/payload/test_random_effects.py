"""Pooling against the textbook: one number is the classical random-effects mean, common causes stay, intervals cover."""

from __future__ import annotations

import numpy as np
import pytest

from core.payload.random_effects import Measured, difference_covariance, pool
from core.payload.series import half_width
from core.payload.uncertain_parameters import UncertainParameters

TRUTH = np.array([2.8, 0.0, -0.047, 0.1, 0.007, 0.0, 0.0, 0.0066, 0.0017, 0.0033])
STD = np.array([1e-4, *[3e-5] * 3, *[5e-6] * 6])


def only_mass(value: float, std: float) -> Measured:
    phi, covariance = np.full(10, np.nan), np.full((10, 10), np.nan)
    phi[0], covariance[0, 0] = value, std**2
    return Measured(UncertainParameters(phi, covariance))


def draw(rng: np.random.Generator, between: float = 0.0) -> Measured:
    return Measured(UncertainParameters(TRUTH + STD * (rng.normal(size=10) + between * rng.normal(size=10)), np.diag(STD**2)))


def test_equal_certainties_give_the_plain_mean_and_the_scatter_s_own_standard_error() -> None:
    values = np.array([2.0, 2.2, 1.9, 2.4, 2.1])
    found = pool([only_mass(v, 1e-3) for v in values])
    assert found.parameters.phi[0] == pytest.approx(values.mean())
    # balanced one-way random effects: REML is the sample variance less the stated one
    assert found.between_std[0] == pytest.approx(np.sqrt(values.var(ddof=1) - 1e-6), rel=1e-4)
    assert found.parameters.std[0] == pytest.approx(values.std(ddof=1) / np.sqrt(5), rel=1e-4)
    assert np.isnan(found.parameters.phi[1:]).all()


def test_runs_that_scatter_as_they_say_are_weighed_by_their_certainty() -> None:
    found = pool([only_mass(2.0, 0.1), only_mass(2.05, 0.2)])
    assert found.between_std[0] == 0.0
    np.testing.assert_allclose(found.weights[:, 0], [0.8, 0.2])
    assert found.excess == pytest.approx(0.05**2 / (0.1**2 + 0.2**2))


def test_a_common_cause_moves_the_mean_and_no_number_of_runs_averages_it_away() -> None:
    rng = np.random.default_rng(1)
    cause = 5.0 * STD[:, None]
    runs = [Measured(draw(rng).own, {"sensor_gain": cause}) for _ in range(50)]
    found = pool(runs)
    np.testing.assert_allclose(found.common_std, 5.0 * STD, rtol=1e-6)
    assert (found.parameters.std > 5.0 * STD).all() and (found.parameters.std < 5.1 * STD).all()


def test_zeros_of_the_joints_that_plans_feel_differently_part_no_runs_that_state_them() -> None:
    rng, called = np.random.default_rng(2), 0
    for _ in range(200):
        zeros = rng.normal(size=7)
        pair = []
        for _ in range(2):
            directions = 30.0 * STD[:, None] * rng.normal(size=(10, 7))
            moved = draw(rng).own.phi + directions @ zeros
            pair.append(Measured(UncertainParameters(moved, np.diag(STD**2)), {"joint_zeros": directions}))
        difference = pair[1].own.phi - pair[0].own.phi
        distance = difference @ np.linalg.solve(difference_covariance(*pair), difference)
        called += distance > 23.21  # the 99 % point of chi-square with ten degrees of freedom
    assert called <= 7  # 200 of 1 %: more than that once in 1000 times


@pytest.mark.parametrize(("count", "between"), [(3, 0.0), (4, 3.0), pytest.param(10, 3.0, marks=pytest.mark.thorough)])
def test_intervals_of_the_mean_cover(count: int, between: float) -> None:
    rng, hits = np.random.default_rng(count), np.zeros(10)
    for _ in range(150):
        found = pool([draw(rng, between) for _ in range(count)])
        half = np.array([half_width(k, found) for k in range(10)])
        hits += np.abs(found.parameters.phi - TRUTH) < half
    assert 0.92 < hits.mean() / 150 < 0.995


def test_a_prior_has_the_share_that_its_certainty_gives_it() -> None:
    prior = UncertainParameters(np.array([3.0, *[np.nan] * 9]), np.diag([0.01, *[np.nan] * 9]))
    found = pool([only_mass(2.0, 0.1), only_mass(2.0, 0.1)], prior)
    assert found.prior_weight[0] == pytest.approx(1.0 / 3.0)
    assert found.parameters.phi[0] == pytest.approx(2.0 + 1.0 / 3.0)
    assert found.weights[:, 0].sum() + found.prior_weight[0] == pytest.approx(1.0)
