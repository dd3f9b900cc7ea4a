"""The offset's random walk: its banded covariance, its rate and its prediction against dense matrices and a simulated walk."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

from core.estimation.banded import difference, factorise, whiten
from core.estimation.drift import (
    STEP_STD,
    Channel,
    RateSearch,
    Slope,
    Walk,
    increments_of_walk,
    level_offsets,
    slope_of,
    variance_between,
    walk_in,
)
from core.estimation.generalised_least_squares import fit
from core.estimation.kinematics import Poses
from core.estimation.noise import WrenchNoise
from core.estimation.weak_form import WeakForm
from tests.core.estimation.test_generalised_least_squares import GRAVITY, STD, swinging, true_phi

K = 120
NOISE = 0.5


def resting(t: np.ndarray) -> WeakForm:
    return WeakForm(Poses(t, np.tile(np.eye(3), (len(t), 1, 1)), np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6))))


def dense(bands: np.ndarray) -> np.ndarray:
    n = bands.shape[1]
    below = sum(np.diag(bands[d, : n - d], -d) for d in range(1, min(len(bands), n)))
    return np.asarray(np.diag(bands[0]) + below + np.transpose(below))


def test_the_increments_of_averaged_walks_have_the_covariance_of_the_samples_that_they_are_made_of() -> None:
    """Three windows are missing in the middle."""
    fine, kept = 50, np.delete(np.arange(20.0), [8, 9, 10])
    t = np.arange(-3.0, 23.0, 1.0 / fine)
    spline = BSpline.basis_element(np.arange(-2.0, 3.0), extrapolate=False)
    W = np.nan_to_num(spline(t - kept[:, None])) / fine
    walks = np.tril(np.ones((len(t), len(t)))) / np.sqrt(fine)
    increments = np.diff(W, axis=0) @ walks
    found = dense(increments_of_walk(kept))
    assert not found[0].any()
    # the samples stand for the time before them
    np.testing.assert_allclose(found[1:, 1:], increments @ increments.T, atol=0.5 / fine)


def test_in_a_pause_the_offset_may_jump_and_rows_that_are_poses_do_not_walk() -> None:
    t = np.concatenate((0.002 * np.arange(2000), 60.0 + 0.002 * np.arange(2000)))
    form = resting(t)
    walk = walk_in(form)
    assert np.flatnonzero(walk.jumps).tolist() == [int(np.flatnonzero(np.diff(form.centres) > 30.0)[0]) + 1]
    added = walk.covariance(2.0, 4) - 2.0 * walk.bands
    np.testing.assert_allclose(added[0], STEP_STD[4] ** 2 * walk.jumps)
    static = WeakForm(form.poses, still_only=np.ones(len(t), dtype=bool))
    assert not walk_in(static).bands.any() and not walk_in(static).jumps.any()


def made(rng: np.random.Generator, rate: float) -> tuple[np.ndarray, np.ndarray]:
    """Three columns, the last one an offset, and what was measured (K,): a walk that begins with zero, seen through white noise."""
    X = np.column_stack((np.sin(0.3 * np.arange(K)), rng.normal(size=K), np.ones(K)))
    walk = np.concatenate(([0.0], np.cumsum(np.sqrt(rate) * rng.normal(size=K - 1))))
    return X, X @ [2.0, -1.0, 5.0] + walk + NOISE * rng.normal(size=K)


UNIT = np.append(0.0, np.ones(K - 1))[None, :]
POINTS = Walk(np.vstack((UNIT, np.zeros((1, K)))), np.zeros(K))


def whitened(rate: float, X: np.ndarray, y: np.ndarray) -> tuple[Channel, np.ndarray, np.ndarray]:
    factor = factorise(difference(NOISE**2 * np.ones((1, K))) + POINTS.covariance(rate, 0))
    w = whiten(factor, np.diff(np.column_stack((X, y)), axis=0, prepend=0.0))
    covariance = np.linalg.inv(w[:, :-1].T @ w[:, :-1])
    beta = covariance @ w[:, :-1].T @ w[:, -1]
    return Channel(factor, w[:, :-1], np.arange(3), w[:, -1] - w[:, :-1] @ beta), covariance, beta


def covariance_of(rate: float) -> np.ndarray:
    k = np.arange(float(K))
    return np.asarray(NOISE**2 * np.eye(K) + rate * np.minimum.outer(k, k))


def restricted_likelihood(rate: float, X: np.ndarray, y: np.ndarray) -> float:
    C = covariance_of(rate)
    information = X.T @ np.linalg.solve(C, X)
    r = y - X @ np.linalg.solve(information, X.T @ np.linalg.solve(C, y))
    return float(-0.5 * (np.linalg.slogdet(C)[1] + np.linalg.slogdet(information)[1] + r @ np.linalg.solve(C, r)))


def searched(X: np.ndarray, y: np.ndarray, steps: int) -> float:
    search = RateSearch(np.array([1e-3]), np.array([1e-8]), np.array([10.0]))
    for _ in range(steps):
        channel, covariance, _ = whitened(search.rate[0], X, y)
        search.improve(0, slope_of(search.rate[0], POINTS.bands, channel, covariance))
    return float(search.rate[0])


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("truth", [0.0, 0.01, 0.2])
def test_the_rate_is_where_a_scan_of_the_dense_likelihood_has_its_largest_value(seed: int, truth: float) -> None:
    X, y = made(np.random.default_rng(seed), truth)
    rates = np.geomspace(1e-8, 10.0, 400)
    scan = [restricted_likelihood(rate, X, y) for rate in rates]
    assert restricted_likelihood(searched(X, y, 12), X, y) > max(scan) - 1e-3


def test_the_estimate_its_covariance_and_the_predicted_walk_are_those_of_the_dense_matrices() -> None:
    rate = 0.05
    X, y = made(np.random.default_rng(9), rate)
    C, k = covariance_of(rate), np.arange(float(K))
    information = X.T @ np.linalg.solve(C, X)
    beta = np.linalg.solve(information, X.T @ np.linalg.solve(C, y))
    walk = rate * np.minimum.outer(k, k)
    drift = walk @ np.linalg.solve(C, y - X @ beta)
    channel, covariance, x = whitened(rate, X, y)
    np.testing.assert_allclose(x, beta, rtol=1e-9)
    np.testing.assert_allclose(covariance, np.linalg.inv(information), rtol=1e-9)
    found = level_offsets(x, covariance, [channel], POINTS, np.array([rate]), slice(2, 3))
    np.testing.assert_allclose(found.drift[:, 0], drift - drift.mean(), atol=1e-9)
    assert found.x[2] == pytest.approx(beta[2] + drift.mean())
    # the same with the walk as unknowns of their own: Henderson's equations
    Z = np.eye(K)[:, 1:]
    joint = np.linalg.inv(
        np.block([[X.T @ X, X.T @ Z], [Z.T @ X, Z.T @ Z]]) / NOISE**2
        + np.block([[np.zeros((3, 3)), np.zeros((3, K - 1))], [np.zeros((K - 1, 3)), np.linalg.inv(walk[1:, 1:])]])
    )
    mean = np.concatenate(([0.0, 0.0, 1.0], np.full(K - 1, 1.0 / K)))
    assert found.covariance[2, 2] == pytest.approx(mean @ joint @ mean)
    assert found.covariance[2, 0] == pytest.approx(mean @ joint[:, 0])
    assert found.drift_std[0] == pytest.approx(np.sqrt(joint[-1, -1]))


def test_a_step_is_bounded() -> None:
    search = RateSearch(np.full(3, 1e-3), np.full(3, 1e-8), np.full(3, 0.05))
    for c, slope in enumerate((Slope(1e9, 1e-9), Slope(1e-9, 0.5), Slope(1.0, 0.5))):
        search.improve(c, slope)
    np.testing.assert_allclose(search.rate, [0.05, 1e-5, 1e-3])


def test_steps_that_lead_past_the_maximum_and_back_come_to_rest_at_it() -> None:
    search, maximum = RateSearch(np.array([1e-3]), np.array([1e-12]), np.array([10.0])), 1e-5
    for _ in range(25):
        off = np.log(search.rate[0] / maximum)
        search.improve(0, Slope(np.exp(-0.2 * off), 0.1))  # each of Newton's steps is twice as long as it should be
    assert search.rate[0] == pytest.approx(maximum, rel=0.01)


def test_between_two_sights_the_walk_is_a_bridge_and_after_the_last_it_walks_away() -> None:
    rng, rate = np.random.default_rng(3), 0.3
    walks = np.cumsum(np.sqrt(rate * 0.01) * rng.normal(size=(4000, 401)), axis=1)
    line = walks[:, :1] + np.linspace(0.0, 1.0, 401) * (walks[:, -1:] - walks[:, :1])
    t, seen = np.array([1.0, 2.0]), np.array([0.0, 4.0])
    found = variance_between(np.full(6, rate), np.zeros(6), np.append(t, 7.0), seen)[:, 0]
    np.testing.assert_allclose(found[:2], (walks - line)[:, [100, 200]].var(axis=0), rtol=0.1)
    assert found[2] == pytest.approx(3.0 * rate)


def test_a_walk_of_the_sensor_is_found_with_its_rate_and_the_intervals_scatter_as_they_say() -> None:
    t, R, wrench = swinging(0.002, 10.0, 1.5)
    form = WeakForm(Poses(t, R, np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6))))
    rate = (0.6 * STD) ** 2
    z, rates = [], []
    for seed in range(8):
        rng = np.random.default_rng(seed)
        walk = np.cumsum(np.sqrt(rate * 0.002) * rng.normal(size=wrench.shape), axis=0)
        found = fit(form, wrench + walk + STD * rng.normal(size=wrench.shape), WrenchNoise(STD, np.ones(6), True))
        assert found.converged
        np.testing.assert_array_equal(found.scale, 1.0)
        z.append((found.phi - true_phi()) / np.sqrt(np.diag(found.covariance)[:10]))
        rates.append(found.walk / rate)
        seen = form.average(walk)
        assert np.abs(found.drift - (seen - seen.mean(axis=0))).max() < 0.5 * np.ptp(seen)
    assert 0.75 < np.sqrt(np.mean(np.square(z))) < 1.3
    assert np.mean(rates) == pytest.approx(1.0, rel=0.25)


def test_where_nothing_walks_next_to_no_precision_is_lost() -> None:
    t, R, wrench = swinging(0.002, 10.0, 1.5)
    form = WeakForm(Poses(t, R, np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6))))
    ratios = []
    for seed in range(6):
        seen = wrench + STD * np.random.default_rng(seed).normal(size=wrench.shape)
        free, held = (fit(form, seen, WrenchNoise(STD, np.ones(6), True, most)) for most in (np.full(6, np.inf), np.zeros(6)))
        ratios.append(np.sqrt(np.diag(free.covariance)[:10] / np.diag(held.covariance)[:10]))
    assert 0.99 < np.median(ratios) < 1.05
