"""Sensor and timing effects against faults that are planted by formulas of their own, and found again by a fit."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares
from scipy.signal import lsim

from core.effects.effect import Effect
from core.effects.kinematic_lag import KinematicLag
from core.effects.scene import Scene
from core.effects.sensor_creep import SensorCreep
from core.effects.sensor_crosstalk import SensorCrosstalk
from core.effects.sensor_drift import SensorDrift
from core.effects.sensor_gain import SensorGain
from core.effects.sensor_hysteresis import SensorHysteresis
from core.effects.sensor_lowpass import SensorLowpass
from core.effects.sensor_nonlinearity import SensorNonlinearity
from core.effects.sensor_offset_step import SensorOffsetStep
from core.effects.sensor_saturation import SensorSaturation
from core.effects.time_delay import TimeDelay
from core.payload.channels import CHANNELS
from core.payload.inertia import Motion
from tests.core.effects.naive_play import naive_play
from tests.core.effects.synthetic_scene import NOISE, scene

Array = np.ndarray
RUN = scene(seconds=18.0)
W = RUN.nominal
SPLINE = CubicSpline(RUN.t, W)
FINE = np.linspace(0, RUN.t[-1], 10 * (len(RUN) - 1) + 1)


def behind(numerator: list[float], denominator: list[float], w: Array) -> Array:
    """`w` behind a transfer function, by matrix exponentials on a grid ten times as fine; at rest at its first value before."""
    spline = CubicSpline(RUN.t, w)
    out = [w[0, j] + lsim((numerator, denominator), spline(FINE)[:, j] - w[0, j], FINE)[1][::10] for j in range(6)]
    return np.column_stack(out)


def crosstalk(entries: dict[tuple[int, int], float]) -> Array:
    """Each reading as the sum of what the channels bring into it."""
    out = [W[:, i].copy() for i in range(6)]
    for (i, j), c in entries.items():
        out[i] += c * W[:, j]
    return np.column_stack(out)


STEP = np.array([1.2, -0.8, 0.0, 0.05, 0.0, -0.08])
DRIFT = np.array([1.0, -0.5, 0.8, 0.03, 0.0, -0.05])
ENTRIES = {(0, 1): 0.02, (2, 0): -0.015, (3, 1): 0.002, (4, 0): -0.001}


@dataclass(frozen=True)
class Case:
    """A planted fault, the parameters that describe it, and how much the model may differ from it, N and N m of largest channel."""

    name: str
    effect: Effect
    planted: Array
    theta: dict[str, float]
    differs: float = 1e-9


CASES = [
    Case("delay between samples", TimeDelay(), SPLINE(np.maximum(RUN.t - 0.0234, 0)), {"delay_s": 0.0234}, 1e-3),
    Case("delay of less than a sample", TimeDelay(), SPLINE(np.maximum(RUN.t - 0.004, 0)), {"delay_s": 0.004}, 1e-3),
    Case(
        "low-pass of first order, 5 Hz", SensorLowpass(), behind([1], [1 / (10 * np.pi), 1], W), {"time_constant_s": 1 / (10 * np.pi)}, 0.02
    ),
    Case(
        "Butterworth of second order, 6 Hz",
        SensorLowpass(),
        behind([1], [(1 / (12 * np.pi)) ** 2, np.sqrt(2) / (12 * np.pi), 1], W),
        {"time_constant_s": np.sqrt(2) / (12 * np.pi), "second_order_share": 0.5},
        0.02,
    ),
    Case(
        "gain",
        SensorGain(),
        np.column_stack([1.03 * W[:, 0], *W[:, 1:5].T, 0.98 * W[:, 5]]),
        {"fx_gain_error_share": 0.03, "tz_gain_error_share": -0.02},
    ),
    Case(
        "cross-talk",
        SensorCrosstalk(),
        crosstalk(ENTRIES),
        {"fx_from_fy_n_per_n": 0.02, "fz_from_fx_n_per_n": -0.015, "tx_from_fy_nm_per_n": 0.002, "ty_from_fx_nm_per_n": -0.001},
    ),
    Case(
        "another gain for pull than for push",
        SensorGain(),
        np.column_stack([np.where(W[:, 0] > 0, 1.03, 0.99) * W[:, 0], *W[:, 1:].T]),
        {"fx_gain_error_share": 0.01, "fx_asymmetry_share": 0.02},
    ),
    Case(
        "cross-talk of pull alone",
        SensorCrosstalk(),
        np.column_stack([W[:, 0] + 0.03 * np.maximum(W[:, 1], 0), *W[:, 1:].T]),
        {"fx_from_fy_n_per_n": 0.03 / np.sqrt(2), "rectification_rad": np.pi / 4},
    ),
    Case(
        "non-linearity",
        SensorNonlinearity(),
        W + np.outer(np.sign(W[:, 1]) * W[:, 1] ** 2 * 0.04 / 145.0, [0, 1, 0, 0, 0, 0]),
        {"fy_full_scale_error_share": 0.04},
    ),
    Case(
        "non-linearity of a sensor that was adjusted at its full load",
        SensorNonlinearity(),
        W - np.outer(0.04 * W[:, 1] * (1 - np.abs(W[:, 1]) / 145.0), [0, 1, 0, 0, 0, 0]),
        {"fy_full_scale_error_share": 0.04, "fy_slope_error_share": -0.04},
    ),
    Case(
        "play",
        SensorHysteresis(),
        np.column_stack([naive_play(W[:, j], 0.004 * full) for j, full in enumerate([145, 145, 290, 5, 5, 5])]),
        {f"{c}_half_width_share": 0.004 for c in CHANNELS} | {f"{c}_turning_load_log_ratio": np.log(0.004) for c in CHANNELS},
    ),
    Case(
        "hysteresis that runs ahead",
        SensorHysteresis(),
        np.column_stack([W[:, 0], 2 * W[:, 1] - naive_play(W[:, 1], 0.435), *W[:, 2:].T]),
        {"fy_half_width_share": -0.003, "fy_turning_load_log_ratio": np.log(0.003)},
    ),
    Case(
        "creep",
        SensorCreep(),
        W + 0.01 * behind([1], [4.0, 1], W) * [1, 1, 1, 0, 0, 0],
        {"fx_creep_share": 0.01, "fy_creep_share": 0.01, "fz_creep_share": 0.01, "time_constant_s": 4.0},
        1e-3,
    ),
    Case(
        "clipping of two channels",
        SensorSaturation(),
        np.column_stack([np.minimum(W[:, 0], 8.0), np.maximum(W[:, 1], -10.0), *W[:, 2:].T]),
        {"fx_upper_limit_per_n": 1 / 8.0, "fy_lower_limit_per_n": 1 / 10.0, "corner_share": 0.005},
        0.015,
    ),
    Case(
        "warming up",
        SensorDrift(),
        W + np.outer(1 - np.exp(-RUN.t / 12.0), DRIFT),
        {
            "settling_rate_per_s": 1 / 12.0,
            **{f"{c}_first_minute_n": a * (1 - np.exp(-5)) for c, a in zip(("fx", "fy", "fz"), DRIFT[:3], strict=True)},
        }
        | {f"{c}_first_minute_nm": a * (1 - np.exp(-5)) for c, a in zip(("tx", "ty", "tz"), DRIFT[3:], strict=True)},
    ),
    Case(
        "jump",
        SensorOffsetStep(),
        W + np.where(RUN.t > 13.37, 1.0, 0.0)[:, None] * STEP,
        {"step_time_s": 13.365, "fx_step_n": 1.2, "fy_step_n": -0.8, "tx_step_nm": 0.05, "tz_step_nm": -0.08},
        1.0,
    ),
]


def theta_of(case: Case) -> Array:
    parameters = case.effect.parameters(RUN)
    unknown = set(case.theta) - {p.name for p in parameters}
    assert not unknown
    return np.array([case.theta.get(p.name, p.absent) for p in parameters])


def fitted(effect: Effect, run: Scene, measured: Array) -> tuple[Array, Array, float]:
    """Parameters and standard deviations of the best fit over the effect's own starts, with free offsets, and its rms in sigma."""
    parameters = effect.parameters(run)
    bounds = np.array([(p.lower, p.upper) for p in parameters]).T
    prior = np.array([p.scale for p in parameters])
    absent = np.array([p.absent for p in parameters])
    w = run.nominal
    every = 1 if isinstance(effect, SensorOffsetStep) else 3  # the time of a jump shows in one sample alone

    def difference(theta: Array) -> Array:
        r = ((measured - effect.wrench(run, w, theta)) / NOISE)[::every]
        return np.concatenate([(r - r.mean(axis=0)).ravel(), 1e-3 * (theta - absent) / prior])

    residual = (measured - w) / NOISE
    inner = (bounds[0] + 1e-6 * prior, bounds[1] - 1e-6 * prior)
    fits = [
        least_squares(difference, np.clip(start, *inner), bounds=bounds, x_scale=prior, max_nfev=25)
        for start in effect.starts(run, residual - residual.mean(axis=0))
    ]
    best = min(fits, key=lambda fit: fit.cost)
    std = np.sqrt(np.diag(np.linalg.inv(best.jac.T @ best.jac)))
    return best.x, std, float(np.sqrt(2 * best.cost / measured[::every].size))


every_case = pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)


@every_case
def test_the_model_with_the_right_parameters_is_the_planted_fault(case: Case) -> None:
    assert np.abs(case.planted - W).max() > 0.02  # it is there
    model = case.effect.wrench(RUN, W, theta_of(case))
    difference = np.abs(model - case.planted)
    if isinstance(case.effect, SensorOffsetStep):
        difference = np.delete(difference, np.abs(RUN.t - 13.37).argmin() + np.arange(-1, 2), axis=0)
    assert difference.max() < (1e-9 if isinstance(case.effect, SensorOffsetStep) else case.differs)


@every_case
def test_a_fit_recovers_the_parameters_without_noise(case: Case) -> None:
    theta, _, rms = fitted(case.effect, RUN, case.planted)
    scale = np.array([p.scale for p in case.effect.parameters(RUN)])
    observable = seen(case)
    assert np.abs((theta - theta_of(case)) / scale)[observable].max() < 0.05
    assert rms < 0.2


@every_case
def test_a_fit_recovers_the_parameters_from_noise_within_its_stated_uncertainty(case: Case) -> None:
    noise = np.random.default_rng(2).standard_normal(W.shape) * NOISE + [3, -2, 5, 0.1, 0.2, -0.3]
    theta, std, rms = fitted(case.effect, RUN, case.planted + noise)
    scale = np.array([p.scale for p in case.effect.parameters(RUN)])
    error = np.abs(theta - theta_of(case)) / np.maximum(std, 0.02 * scale)
    assert error[seen(case)].max() < 4.5
    assert rms == pytest.approx(1.0, abs=0.03)


def seen(case: Case) -> Array:
    """Which parameters the data determine: limits that no load reaches, and the form of a filter, are not asked for."""
    names = [p.name for p in case.effect.parameters(RUN)]
    if isinstance(case.effect, SensorSaturation):
        return np.array([name in case.theta for name in names])
    if case.name == "hysteresis that runs ahead":
        return np.array([name in case.theta for name in names])
    return np.array([name != "turning_spread_log_ratio" for name in names])


def test_a_lagging_motion_is_led_back_to_the_true_wrench() -> None:
    lag = 0.02
    recorded = behind([1], [lag, 1], W)
    corrected = KinematicLag().wrench(RUN, recorded, np.array([lag]))
    before, after = np.abs(recorded - W).max(axis=0), np.abs(corrected - W).max(axis=0)
    assert (after < 0.1 * before).all()


def test_a_fit_finds_the_lag_of_the_motion() -> None:
    recorded = behind([1], [0.02, 1], W)
    noisy = W + np.random.default_rng(4).standard_normal(W.shape) * NOISE
    fit = least_squares(lambda theta: ((noisy - KinematicLag().wrench(RUN, recorded, theta)) / NOISE).ravel(), [0.005], x_scale=0.01)
    assert fit.x[0] == pytest.approx(0.02, rel=0.05)


def test_gentle_hysteresis_of_the_bouc_wen_kind_is_explained_too() -> None:
    """Another shape than the model's: `dz = (1 - |z|^n (beta + gamma sign(z dx))) dx / a`."""
    x, z = W[:, 1], np.zeros(len(W))
    for k in range(1, len(z)):
        dx = (x[k] - x[k - 1]) / 3.0
        z[k] = z[k - 1] + dx * (1 - abs(z[k - 1]) * (0.6 + 0.4 * np.sign(z[k - 1] * dx)))
    planted = W.copy()
    planted[:, 1] += -0.4 * z
    _, _, after = fitted(SensorHysteresis(), RUN, planted)
    shift = (planted - W) / NOISE
    before = float(np.sqrt(((shift - shift.mean(axis=0)) ** 2).mean()))
    assert after < 0.2 * before


@pytest.mark.parametrize("effect", [TimeDelay(), SensorLowpass(), KinematicLag()], ids=lambda effect: effect.id)
def test_timing_does_not_show_where_nothing_moves(effect: Effect) -> None:
    still = replace(RUN, motion=Motion.still(RUN.motion.g))
    assert effect.explain_absence(still).code == "effect-sensor-still"
    assert effect.explain_absence(RUN) is None


@pytest.mark.parametrize("effect", [SensorNonlinearity(), SensorHysteresis()], ids=lambda effect: effect.id)
def test_where_the_range_is_unknown_the_largest_load_is_full_scale(effect: Effect) -> None:
    unknown = replace(RUN, range=None)
    largest = replace(RUN, range=np.maximum(np.abs(W).max(axis=0), [1, 1, 1, 0.05, 0.05, 0.05]))
    theta = np.array([p.absent + 0.5 * p.scale for p in effect.parameters(RUN)])
    np.testing.assert_array_equal(effect.wrench(unknown, W, theta), effect.wrench(largest, W, theta))


@pytest.mark.parametrize(
    ("effect", "theta", "number"),
    [
        (TimeDelay(), [0.0123], "12.3 ms"),
        (KinematicLag(), [0.0123], "12.3 ms"),
        (SensorLowpass(), [1 / (10 * np.pi), 0.0], "5 Hz"),
        (SensorGain(), [0, 0.031, 0, 0, 0, 0, 0, 0.01, 0, 0, 0, 0], "fy is off by 4.1 % where it is positive and by 2.1 %"),
        (SensorCreep(), [0, 0, 0.004, 0, 0, 0, 20.0], "60 s"),
        (SensorHysteresis(), [0.002, *[0] * 12], "0.40 %"),
        (SensorOffsetStep(), [1.5, 0, 0, 0, 0, 0.02, 7.1], "7.1 s"),
        (SensorSaturation(), [0.125, *[0] * 11, 0.02], "above 8 N"),
    ],
    ids=lambda value: getattr(value, "id", None),
)
def test_advice_says_the_numbers_in_everyday_units(effect: Effect, theta: list[float], number: str) -> None:
    assert number in effect.advice(RUN, np.array(theta)).text


def test_a_limit_that_no_load_reaches_is_none() -> None:
    theta = np.append(np.full(12, 1e-310), 0.02)  # as a step towards zero ends
    np.testing.assert_array_equal(SensorSaturation().wrench(RUN, W, theta), W)
