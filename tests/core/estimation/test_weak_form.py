"""The windowed equations: exact without noise, at corners too, and with the noise they claim."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.estimation.banded import factorise, whiten
from core.estimation.kinematics import Poses, poses_of
from core.estimation.weak_form import WeakForm, regressor_of, second_difference, tilt_axes, wrench_of
from core.payload.inertia import Motion, regressor, skew
from tests.synthetic import GRAVITY, Imperfections, payload, record, run_of

EXACT = Imperfections(noise_std=np.full(6, 1e-12), encoder_std=0.0, resolution=None, offset=np.zeros(6))


@given(st.integers(0, 2**32 - 1))
def test_the_regressor_of_second_derivatives_is_that_of_eq_2(seed: int) -> None:
    rng = np.random.default_rng(seed)
    g, a, omega, alpha = rng.normal(size=(4, 6, 3))
    B = skew(alpha) + skew(omega) @ skew(omega)
    np.testing.assert_allclose(regressor_of(a - g, B), regressor(Motion(g, a, omega, alpha)), atol=1e-12)


@given(st.integers(0, 2**32 - 1))
def test_the_wrench_is_the_regressor_times_the_parameters(seed: int) -> None:
    rng = np.random.default_rng(seed)
    b, B, phi = rng.normal(size=(5, 3)), rng.normal(size=(5, 3, 3)), rng.normal(size=10)
    np.testing.assert_allclose(wrench_of(b, B, phi), regressor_of(b, B) @ phi, atol=1e-12)


@pytest.mark.parametrize("lag", [150.0, 600.0])
def test_windowed_wrench_and_windowed_regressor_agree_even_at_the_corners_of_the_trapezoids(lag: float) -> None:
    body = payload("steel_block")
    recording = record(run_of("lwr4_bench", 0, lag=lag), body, np.random.default_rng(0), EXACT)
    poses = poses_of(recording)
    assert poses is not None and recording.wrench is not None
    form = WeakForm(poses)
    features, _ = form.features(0.0)
    residual = form.average(recording.wrench) - features.regressor(np.zeros(2)) @ body.phi
    # a thousandth of what the accelerations cause
    assert np.abs(residual[:, :3]).max() < 1e-3
    assert np.abs(residual[:, 3:]).max() < 3e-5


def test_shifted_windows_see_a_late_wrench_in_time() -> None:
    body = payload("steel_block")
    run = run_of("lwr4_bench", 1)
    late = Imperfections(noise_std=np.full(6, 1e-12), encoder_std=0.0, resolution=None, offset=np.zeros(6), delay_s=0.0042)
    recording = record(run, body, np.random.default_rng(0), late)
    poses = poses_of(recording)
    assert poses is not None and recording.wrench is not None
    form = WeakForm(poses)
    y = form.average(recording.wrench)
    shifted, rate = form.features(0.0042)
    assert np.abs(y - shifted.regressor(np.zeros(2)) @ body.phi)[:, :3].max() < 5e-3
    ahead, _ = form.features(0.0043)
    change = (ahead.regressor(np.zeros(2)) - shifted.regressor(np.zeros(2))) @ body.phi / 1e-4
    slope = (rate.regressor(np.zeros(2)) - 0.0) @ body.phi
    assert np.abs(change - slope).max() < 0.02 * np.abs(slope).max()


def test_the_covariance_of_the_windowed_noise_is_what_the_gram_says() -> None:
    rng = np.random.default_rng(1)
    n = 6000
    t = 1e-3 * np.arange(n)
    poses = Poses(t, np.tile(np.eye(3), (n, 1, 1)), np.zeros((n, 3)), GRAVITY, np.zeros((6, 6)))
    form = WeakForm(poses)
    white, _ = form.gram
    means = form.average(rng.normal(size=(n, 800)))
    k = len(form) // 2
    assert np.mean(means[5:-5] ** 2) == pytest.approx(white[0, k], rel=0.02)
    assert np.mean(means[5:-6] * means[6:-5]) == pytest.approx(white[1, k], rel=0.03)
    assert np.mean(whiten(factorise(white), means) ** 2) == pytest.approx(1.0, rel=0.02)


def test_what_jitter_adds_to_the_windowed_accelerations_is_what_the_gram_says() -> None:
    rng = np.random.default_rng(4)
    n, jitter_s, lever_m = 20_000, 1e-3, 0.5
    t = 4e-3 * np.arange(n)
    speed = np.where(t < t[n // 2], 0.3, 2.0)
    angle = np.cumsum(speed * 4e-3) + speed * jitter_s * rng.normal(size=n)
    turned = np.array([pin.exp3(np.array([0.0, 0.0, v])) for v in angle])
    form = WeakForm(Poses(t, turned, turned @ [lever_m, 0.0, 0.0], GRAVITY, np.zeros((6, 6)), jitter_s=jitter_s))
    features, _ = form.features(0.0)
    _, gram = form.gram
    # across the way, too: the axes turn while the error of an instant lasts (Coriolis)
    for seen, row in ((features.a[:, 0], 0), (features.a[:, 1], 1), (0.5 * (features.B[:, 1, 0] - features.B[:, 0, 1]), 5)):
        said = gram.find_variance_through(np.eye(6)[row])[0]
        for half in (slice(20, len(form) // 2 - 20), slice(len(form) // 2 + 20, -20)):
            assert np.var(seen[half]) == pytest.approx(said[half].mean(), rel=0.15)
        assert said[-40] > 20.0 * said[40]


def test_second_differences_of_a_quartic_are_exact_on_an_uneven_clock() -> None:
    t = np.cumsum(np.random.default_rng(0).uniform(0.5, 1.5, 50))
    np.testing.assert_allclose((second_difference(t) @ (3.0 * t**2 - t**4))[2:-2], (6.0 - 12.0 * t**2)[2:-2], rtol=1e-6, atol=1e-6)
    assert second_difference(t[:4]).nnz == 0


def test_noise_of_the_encoders_does_not_bias_the_acceleration() -> None:
    rng = np.random.default_rng(2)
    n, std = 20_000, 1e-4
    t = 1e-3 * np.arange(n)
    turned = np.array([pin.exp3(v) for v in std * rng.normal(size=(n, 3))])
    lever = turned @ [0.0, 0.0, 1.0]
    form = WeakForm(Poses(t, turned, lever, GRAVITY, np.zeros((6, 6))))
    mean = form.features(0.0)[0].a.mean(axis=0)
    # with the sample's own rotation the product of noises would give -2 std^2 / dt^2 = 0.02 m/s2 along z and more
    assert np.abs(mean).max() < 2e-3


def test_windows_over_a_gap_are_left_out() -> None:
    t = np.concatenate((1e-3 * np.arange(4000), 7.0 + 1e-3 * np.arange(4000)))
    poses = Poses(t, np.tile(np.eye(3), (8000, 1, 1)), np.zeros((8000, 3)), GRAVITY, np.zeros((6, 6)))
    centres = WeakForm(poses).centres
    assert len(centres) > 100
    assert not ((centres > 3.9) & (centres < 7.05)).any()


def test_the_tilt_axes_are_those_that_gravity_can_tell() -> None:
    np.testing.assert_allclose(tilt_axes(GRAVITY), np.eye(3)[:, :2])
    sideways = tilt_axes(np.array([9.81, 0.0, 0.0]))
    np.testing.assert_allclose(sideways.T @ [1.0, 0.0, 0.0], 0.0)
