"""Walk and flicker of the offset: their banded covariances, their prediction, and what a fit makes of simulated ones."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.spatial.transform import Rotation

from core.estimation.annihilating_filter import AnnihilatingFilter
from core.estimation.drift import (
    FLICKER_KNOTS,
    STEP_STD,
    Drift,
    covariance_of_exponential,
    drift_in,
    flicker_between_means,
    level_offsets,
    variance_between,
    variogram_of_walk,
)
from core.estimation.generalised_least_squares import fit
from core.estimation.identification import identify_recording
from core.estimation.kinematics import Poses
from core.estimation.noise import WrenchNoise
from core.estimation.trend import Trend
from core.estimation.variance_search import Channel
from core.estimation.weak_form import WeakForm
from core.estimation.window_covariance import WindowCovariance
from core.recording.recording import Recording
from tests.core.estimation.test_generalised_least_squares import GRAVITY, STD, swinging, true_phi
from tests.foreign_recordings import Condition, make

K = 120
NOISE = 0.5


def resting(t: np.ndarray) -> WeakForm:
    return WeakForm(Poses(t, np.tile(np.eye(3), (len(t), 1, 1)), np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6))))


def dense(bands: np.ndarray) -> np.ndarray:
    n = bands.shape[1]
    below = sum(np.diag(bands[d, : n - d], -d) for d in range(1, min(len(bands), n)))
    return np.asarray(np.diag(bands[0]) + below + np.transpose(below))


def splines(knots: np.ndarray, fine: int) -> tuple[np.ndarray, np.ndarray]:
    """Instants, in knots, and the weights (K, N) of windows on them."""
    t = np.arange(knots[0] - 3.0, knots[-1] + 3.0, 1.0 / fine)
    spline = BSpline.basis_element(np.arange(-2.0, 3.0), extrapolate=False)
    return t, np.nan_to_num(spline(t - knots[:, None])) / fine


def test_averaged_walks_change_as_the_samples_that_they_are_made_of() -> None:
    """The samples stand for the time before them."""
    fine, knots = 50, np.array([0.0, 1.0, 2.0, 3.0, 5.0, 9.0, 20.0])
    t, W = splines(knots, fine)
    walks = W @ np.tril(np.ones((len(t), len(t)))) / np.sqrt(fine)
    expected = ((walks - walks[0]) ** 2).sum(axis=1)
    np.testing.assert_allclose(variogram_of_walk(knots), expected, atol=0.5 / fine)


@pytest.mark.parametrize("time_constant", [0.7, *FLICKER_KNOTS])
def test_averaged_exponentials_have_the_covariance_of_their_samples(time_constant: float) -> None:
    knots = np.array([0.0, 1.0, 2.0, 3.0, 4.0, 7.0, 30.0])
    t, W = splines(knots, 60)
    expected = W @ np.exp(-np.abs(np.subtract.outer(t, t)) / time_constant) @ W.T
    np.testing.assert_allclose(covariance_of_exponential(knots, time_constant), expected[0], rtol=2e-3, atol=1e-6)


def test_nothing_of_the_slow_covariances_lies_beyond_the_bands_and_in_a_pause_the_offset_may_jump() -> None:
    t = np.concatenate((0.002 * np.arange(700), 60.0 + 0.002 * np.arange(700)))
    form = resting(t)
    drift = drift_in(form)
    knots = np.rint((form.centres - form.centres[0]) / form.spacing)
    D, lag = drift.filter.apply(np.eye(len(form))), np.subtract.outer(knots, knots)
    for each, bands in zip(FLICKER_KNOTS, drift.flicker, strict=True):
        np.testing.assert_allclose(dense(bands), D @ covariance_of_exponential(lag, each) @ D.T, atol=1e-4)
    from_first = variogram_of_walk(knots)
    walk = 0.5 * form.spacing * (from_first[:, None] + from_first - variogram_of_walk(lag))
    np.testing.assert_allclose(dense(drift.walk), D @ walk @ D.T, atol=1e-8)
    after = (form.centres > 30.0).astype(float)
    np.testing.assert_allclose(dense(drift.jumps), np.outer(D @ after, D @ after), atol=1e-8)
    added = drift.covariance(np.zeros(4), 4)
    np.testing.assert_allclose(added.bands, STEP_STD[4] ** 2 * drift.jumps)
    assert not added.columns.any()


def test_the_offset_of_rows_at_rest_walks_from_each_to_the_next_whenever_that_is() -> None:
    t = np.cumsum(np.random.default_rng(0).uniform(0.002, 3.0, 60))
    drift = drift_in(WeakForm(resting(t).poses, still_only=np.ones(len(t), dtype=bool)))
    D, since = drift.filter.apply(np.eye(len(t))), t - t[0]
    np.testing.assert_allclose(dense(drift.walk), D @ np.minimum.outer(since, since) @ D.T, atol=1e-9)
    assert drift.shared.shape == (len(t), 4)
    assert not drift.flicker.any() and not drift.jumps.any()


DRIFTING: list[dict[str, Any]] = [{"drift_n": 0.3}, {"drift_n": 1.0}, {"walk_n": 0.04}]
SLOW: list[dict[str, Any]] = [{"rate_hz": 20.0}, {"poses": True}, {"averaged": True}]


@pytest.mark.parametrize(
    ("slow", "drifting"),
    [
        pytest.param(slow, drifting, marks=() if i == j == 1 else pytest.mark.thorough)
        for i, slow in enumerate(SLOW)
        for j, drifting in enumerate(DRIFTING)
    ],
)
def test_intervals_from_rows_at_rest_hold_though_the_offset_drifts(slow: dict[str, Any], drifting: dict[str, Any]) -> None:
    off = []
    for seed in range(4):
        made = make(Condition(**slow, **drifting), seed)
        estimate = identify_recording(made.recording).estimate
        assert estimate is not None and estimate.determined[:4].all()
        off.append((estimate.phi[:4] - made.phi[:4]) / estimate.std[:4])
    assert np.sqrt(np.mean(np.square(off))) < 1.8
    assert np.abs(off).max() < 4.5


def test_a_slow_series_whose_sensor_turns_on_and_on_keeps_its_mass() -> None:
    """Gravity in the sensor goes as slowly as a walk would, and the walk leaves it alone."""
    rng, gravity, mass, place = np.random.default_rng(1), np.array([0.0, 0.0, -9.81]), 2.0, np.array([0.01, -0.02, 0.08])
    for seconds in (1.0, 20.0):
        turned = Rotation.from_euler("xy", np.column_stack((np.linspace(0.0, 2.6, 100), np.linspace(0.2, -0.9, 100)))).as_matrix()
        force = -mass * gravity @ turned
        wrench = np.column_stack((force, np.cross(place, force))) + rng.normal(size=(100, 6)) * ([0.06] * 3 + [0.003] * 3)
        estimate = identify_recording(Recording(seconds * np.arange(100), gravity, wrench=wrench, orientation=turned)).estimate
        assert estimate is not None
        assert abs(estimate.phi[0] - mass) < 3.5 * estimate.repeatability.std[0] < 0.05 * mass


def test_neighbouring_means_of_flicker_differ_as_simulated_ones_do() -> None:
    length, spacing, count = 0.3, 0.025, 1200
    t = np.arange(count) * length / (count // 2)
    weights = np.where(np.arange(count) < count // 2, 1.0, -1.0) / (count // 2)
    for each, found in zip(FLICKER_KNOTS, flicker_between_means(length, spacing), strict=True):
        C = np.exp(-np.abs(np.subtract.outer(t, t)) / (spacing * each))
        assert found == pytest.approx(weights @ C @ weights, rel=0.01)


def test_the_estimate_its_covariance_and_the_predicted_drift_are_those_of_the_dense_matrices() -> None:
    rng, sizes, k = np.random.default_rng(9), np.array([0.3, 0.2, 0.05, 0.7]), np.arange(float(K))
    filtering = AnnihilatingFilter.of(k, (2.0, 5.0))
    D = filtering.apply(np.eye(K))
    walk, fast, decay = np.minimum.outer(k, k), *(np.exp(-np.abs(np.subtract.outer(k, k)) / each) for each in (2.0, 5.0))
    bands = np.array([[np.pad(np.diag(D @ S @ D.T, -d), (0, d)) for d in range(4)] for S in (fast, decay, walk)])
    smooth = np.polynomial.legendre.legvander(np.linspace(-1.0, 1.0, K), 4)[:, 1:] * [1.0, 1 / 4, 1 / 9, 1 / 16]
    drift = Drift(filtering, bands[:2], bands[2], np.zeros((4, K)), Trend(0.0, K - 1.0), D @ smooth)
    slow = sizes[0] * fast + sizes[1] * decay + sizes[2] * walk + sizes[3] * smooth @ smooth.T
    C = NOISE**2 * np.eye(K) + slow
    X = np.column_stack((np.sin(0.3 * k), rng.normal(size=K), np.ones(K)))
    y = X @ [2.0, -1.0, 5.0] + np.linalg.cholesky(C) @ rng.normal(size=K)
    information = X.T @ np.linalg.solve(C, X)
    beta = np.linalg.solve(information, X.T @ np.linalg.solve(C, y))
    predicted = slow @ np.linalg.solve(C, y - X @ beta)
    added = drift.covariance(sizes, 0)
    factor = WindowCovariance(filtering.covariance(NOISE**2 * np.ones((1, K)), 4) + added.bands, added.columns).factorise()
    w = factor.whiten(filtering.apply(np.column_stack((X, y))))
    covariance = np.linalg.inv(w[:, :-1].T @ w[:, :-1])
    x = covariance @ w[:, :-1].T @ w[:, -1]
    np.testing.assert_allclose(x, beta, rtol=1e-7)
    np.testing.assert_allclose(covariance, np.linalg.inv(information), rtol=1e-7)
    channel = Channel(factor, w[:, :-1], np.arange(3), np.asarray(w[:, -1] - w[:, :-1] @ x))
    found = level_offsets(x, np.asarray(covariance), [channel], drift, sizes[None], slice(2, 3))
    np.testing.assert_allclose(found.drift[:, 0], predicted - predicted.mean(), atol=1e-7)
    assert found.x[2] == pytest.approx(beta[2] + predicted.mean())
    # what is not known of a sum of the drift and the unknowns, once they have been predicted from y
    gain = np.linalg.solve(information, X.T @ np.linalg.inv(C))
    rest = slow @ np.linalg.inv(C) @ (np.eye(K) - X @ gain)

    def variance(of_beta: np.ndarray, of_drift: np.ndarray) -> float:
        error = of_beta @ gain + of_drift @ rest  # of y; y is noise and drift
        return float(error @ C @ error - 2.0 * error @ slow @ of_drift + of_drift @ slow @ of_drift)

    mean, ends = np.full(K, 1.0 / K), np.zeros(K)
    ends[0], ends[-1] = -1.0, 1.0
    assert found.covariance[2, 2] == pytest.approx(variance(np.array([0.0, 0.0, 1.0]), mean))
    assert found.drift_std[0] == pytest.approx(np.sqrt(variance(np.zeros(3), ends)))
    # the trend alone: its coefficients given y, and what is not known of them
    of_trend = sizes[3] * smooth.T @ np.linalg.solve(C, np.eye(K) - X @ gain)
    np.testing.assert_allclose(found.trend.coefficients[0], of_trend @ y, atol=1e-8)
    left = sizes[3] * np.eye(4) - sizes[3] * of_trend @ smooth
    np.testing.assert_allclose(found.trend.covariance[0], left, atol=1e-8)


def test_between_two_sights_the_walk_is_a_bridge_and_after_the_last_it_walks_away() -> None:
    rng, rate, none = np.random.default_rng(3), 0.3, np.zeros(6)
    walks = np.cumsum(np.sqrt(rate * 0.01) * rng.normal(size=(4000, 401)), axis=1)
    line = walks[:, :1] + np.linspace(0.0, 1.0, 401) * (walks[:, -1:] - walks[:, :1])
    t, seen = np.array([1.0, 2.0]), np.array([0.0, 4.0])
    found = variance_between(np.zeros((6, 2)), np.full(6, rate), none, np.append(t, 7.0), seen, 0.025)[:, 0]
    np.testing.assert_allclose(found[:2], (walks - line)[:, [100, 200]].var(axis=0), rtol=0.1)
    assert found[2] == pytest.approx(3.0 * rate)
    flicker = variance_between(np.full((6, 2), 0.2), none, none, np.array([0.0, 100.0]), seen, 0.025)[:, 0]
    np.testing.assert_allclose(flicker, [0.0, 0.4], atol=1e-9)


def swung(seconds: float = 10.0, period: float = 0.002) -> tuple[WeakForm, np.ndarray]:
    t, R, wrench = swinging(period, seconds, 1.5)
    return WeakForm(Poses(t, R, np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6)))), wrench


def test_a_walk_of_the_sensor_is_found_with_its_rate_and_the_intervals_scatter_as_they_say() -> None:
    form, wrench = swung()
    rate = (0.6 * STD) ** 2
    z, rates = [], []
    for seed in range(8):
        rng = np.random.default_rng(seed)
        walk = np.cumsum(np.sqrt(rate * 0.002) * rng.normal(size=wrench.shape), axis=0)
        found = fit(form, wrench + walk + STD * rng.normal(size=wrench.shape), WrenchNoise(STD, np.ones(6), True))
        assert found.converged
        np.testing.assert_array_equal(found.scale, 1.0)
        z.append((found.phi - true_phi()) / np.sqrt(np.diag(found.covariance)[:10]))
        # within half a second flicker's slower process walks, too
        rates.append((found.sizes[:, 3] + 2.0 * found.sizes[:, 2] / (FLICKER_KNOTS[1] * form.spacing)) / rate)
        seen = form.average(walk)
        assert np.abs(found.drift - (seen - seen.mean(axis=0))).max() < 0.5 * np.ptp(seen)
    assert 0.75 < np.sqrt(np.mean(np.square(z))) < 1.3
    assert np.mean(rates) == pytest.approx(1.0, rel=0.25)


def warmed(t: np.ndarray) -> np.ndarray:
    """(N, 6), a warm-up of 20 times the noise."""
    return np.asarray(20.0 * STD * (1.0 - np.exp(-2.0 * t / t[-1]))[:, None])


def test_after_a_warm_up_the_intervals_scatter_as_they_say_and_are_hardly_wider_than_beside_four_unknown_waves() -> None:
    """The bound: nothing is known of the coefficients of each channel's polynomials; tilt and delay are as unknown as to the fit."""
    form, wrench = swung(40.0, 0.01)
    t = form.poses.t
    features, rate = form.features(0.0)
    V, late = features.regressor(np.zeros(2)), rate.regressor(np.zeros(2)) @ true_phi()
    V = np.concatenate((V, features.tilt_columns(true_phi(), np.zeros(2)), late[..., None]), axis=2)
    whole = np.diag(np.concatenate((np.zeros(10), [0.05**-2, 0.05**-2, 0.02**-2], np.full(30, 1e-9))))
    W = form.average(np.eye(len(t)))
    C, ramp = W @ W.T, form.average(warmed(t))
    waves = np.polynomial.legendre.legvander(np.linspace(-1.0, 1.0, len(V)), 4)
    for c in range(6):
        X = np.column_stack((V[:, c], np.kron(np.eye(6)[c], waves)))
        whole += X.T @ np.linalg.solve(STD[c] ** 2 * C, X)
    least = np.sqrt(np.diag(np.linalg.inv(whole))[:10])
    z, widths = [], []
    for seed in range(6):
        seen = wrench + warmed(t) + STD * np.random.default_rng(seed).normal(size=wrench.shape)
        found = fit(form, seen, WrenchNoise(STD, np.ones(6), True))
        assert found.converged
        std = np.sqrt(np.diag(found.covariance)[:10])
        z.append((found.phi - true_phi()) / std)
        widths.append(std / least)
        assert np.abs(found.drift - (ramp - ramp.mean(axis=0))).max() < 0.1 * np.ptp(ramp)
    assert 0.75 < np.sqrt(np.mean(np.square(z))) < 1.3
    assert np.mean(widths, axis=0).max() < 1.3


def test_where_there_are_no_windows_the_trend_goes_on_as_it_has_begun() -> None:
    form, wrench = swung(40.0, 0.01)
    t = form.poses.t
    seen = wrench + warmed(t) + STD * np.random.default_rng(1).normal(size=wrench.shape)
    found = fit(WeakForm(form.poses, within=(t < 16.0) | (t > 28.0)), seen, WrenchNoise(STD, np.ones(6), True))
    between = np.linspace(17.0, 27.0, 9)
    at, variance = found.drift_at(between)
    line = np.column_stack([np.interp(between, found.centres, each) for each in found.drift.T])
    truth = warmed(t)[0] + 20.0 * STD * (1.0 - np.exp(-2.0 * between / t[-1]))[:, None]
    error, of_line = (each - truth + (truth - each).mean(axis=0) for each in (at, line))
    assert np.abs(error).max() < 4.0 * np.sqrt(variance.max()) + 0.2 * STD.max()
    assert np.square(error / STD).mean() < 0.3 * np.square(of_line / STD).mean()


def test_a_recording_as_short_as_the_robots_motions_has_no_trend_and_a_longer_one_the_more_orders_the_longer_it_is() -> None:
    orders = [Trend(3.0, 3.0 + lasts_s).orders for lasts_s in (0.0, 6.0, 12.0, 25.0, 60.0, 3600.0)]
    assert orders == [0, 0, 1, 2, 4, 4]
    bare = swung(6.0)
    found = fit(bare[0], bare[1] + STD * np.random.default_rng(2).normal(size=bare[1].shape), WrenchNoise(STD, np.ones(6), True))
    bent, variance = found.trend.between(np.linspace(0.0, 6.0, 5), found.centres)
    assert not bent.any()
    assert not variance.any()


def pink(rng: np.random.Generator, count: int) -> np.ndarray:
    """(count, 6), of unit variance: 1/f from one period of the record to half the rate."""
    spectrum = np.fft.rfft(rng.normal(size=(count, 6)), axis=0)
    spectrum[1:] /= np.sqrt(np.arange(1, len(spectrum)))[:, None]
    noise = np.fft.irfft(spectrum, n=count, axis=0)
    return np.asarray(noise / noise.std(axis=0))


def test_intervals_after_pink_noise_scatter_as_they_say_and_are_hardly_wider_than_those_of_who_knows_the_covariance() -> None:
    form, wrench = swung()
    n = len(wrench)
    # who knows the covariance, channel by channel, with the same columns: offset and regressor, nothing else unknown
    spectrum = 1.0 / np.maximum(np.arange(n // 2 + 1), 1.0)
    circle = np.fft.irfft(spectrum, n=n)
    W = form.average(np.eye(n))
    C = W @ np.fft.irfft(np.fft.rfft(W, axis=1) * np.fft.rfft(circle / circle[0]).real, n=n, axis=1).T
    V, whole = form.features(0.0)[0].regressor(np.zeros(2)), np.zeros((16, 16))
    for c in range(6):
        X = np.column_stack((V[:, c], np.outer(np.ones(len(V)), np.eye(6)[c])))
        whole += X.T @ np.linalg.solve(STD[c] ** 2 * C, X)
    least = np.sqrt(np.diag(np.linalg.inv(whole))[:10])
    z, widths = [], []
    for seed in range(8):
        found = fit(form, wrench + STD * pink(np.random.default_rng(seed), n), WrenchNoise(0.7 * STD, np.full(6, 5.0), True))
        std = np.sqrt(np.diag(found.covariance)[:10])
        z.append((found.phi - true_phi()) / std)
        widths.append(std / least)
    assert 0.75 < np.sqrt(np.mean(np.square(z))) < 1.3
    assert np.mean(widths, axis=0).max() < 1.5


def test_where_nothing_drifts_little_precision_is_lost_in_ten_seconds_without_any_bound() -> None:
    form, wrench = swung()
    ratios = []
    for seed in range(6):
        seen = wrench + STD * np.random.default_rng(seed).normal(size=wrench.shape)
        free, held = (fit(form, seen, WrenchNoise(STD, np.ones(6), True, most)) for most in (np.full(6, np.inf), np.zeros(6)))
        ratios.append(np.sqrt(np.diag(free.covariance)[:10] / np.diag(held.covariance)[:10]))
    assert 0.99 < np.median(ratios) < 1.08
