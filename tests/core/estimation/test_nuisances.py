"""Columns of the nuisances against what a generator of their own makes of them, and whether causes are told apart."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from core.estimation.budget import Budget
from core.estimation.estimate import Estimate
from core.estimation.identification import identify_recording
from core.estimation.nuisances import find_evidence, improve_strength
from core.payload.calibration import NOT_STATED
from tests.foreign_bound import least_std
from tests.foreign_recordings import Condition, Made, make

CLEAN = Condition(rate_hz=250.0)


@cache
def found(condition: Condition, seed: int) -> tuple[Made, Estimate]:
    made = make(condition, seed)
    estimate = identify_recording(made.recording).estimate
    assert estimate is not None
    return made, estimate


def rms_of_z(condition: Condition, seeds: range) -> np.ndarray:
    """(10,), errors in units of the combined standard uncertainty."""
    z = [(estimate.phi - made.phi) / estimate.std for made, estimate in (found(condition, seed) for seed in seeds)]
    return np.asarray(np.sqrt(np.mean(np.square(z), axis=0)))


@pytest.mark.parametrize(
    "condition",
    [
        CLEAN,
        Condition(rate_hz=250.0, zero_std_rad=8.7e-4),
        pytest.param(Condition(rate_hz=250.0, gain_std=0.01), marks=pytest.mark.thorough),
        pytest.param(Condition(rate_hz=250.0, mount_std_rad=8.7e-3), marks=pytest.mark.thorough),
    ],
    ids=["nothing", "zeros", "gains", "mounting"],
)
def test_intervals_hold_the_truth_whatever_is_wrong(condition: Condition) -> None:
    rms = rms_of_z(condition, range(6))
    # six draws: a factor of two is chance, what is left out of the uncertainty makes tens
    assert (rms < 2.0).all()


@pytest.mark.parametrize(
    "condition",
    [CLEAN, Condition(rate_hz=250.0, zero_std_rad=8.7e-4), Condition(rate_hz=250.0, gain_std=0.01)],
    ids=["nothing", "zeros", "gains"],
)
def test_intervals_are_about_as_narrow_as_motion_and_noise_allow(condition: Condition) -> None:
    for seed in range(2):
        made, estimate = found(condition, seed)
        least = least_std(condition, made)
        assert least is not None
        assert (estimate.std > 0.9 * least).all()
        assert (estimate.std < 1.5 * least).all()


def test_zeros_that_are_off_do_not_reach_the_mass() -> None:
    """The wrench that is not explained by any payload tells them; what is left is far below the 0.04 % that they cost untreated."""
    condition = Condition(rate_hz=250.0, zero_std_rad=8.7e-4)
    errors = [(estimate.phi[0] - made.phi[0]) / made.phi[0] for made, estimate in (found(condition, seed) for seed in range(6))]
    # gravity itself is uncertain to 5e-5
    assert np.sqrt(np.mean(np.square(errors))) < 1.5e-4


def test_gains_are_the_largest_part_where_they_are_stated_to_be_off() -> None:
    _, estimate = found(Condition(rate_hz=250.0, gain_std=0.01), 0)
    assert estimate.budget.largest[0] == "sensor_gain"
    assert 0.004 < estimate.budget.parts["sensor_gain"][0] / estimate.phi[0] < 0.0105
    assert estimate.budget.assumptions(estimate.determined) == ()


def test_clean_data_lose_no_precision_to_what_might_be_off() -> None:
    """A recording without such errors, stated to be free of them, and with everything assumed: it repeats alike."""
    made, certain = found(CLEAN, 1)
    sensor = replace(made.recording.sensor, calibration=NOT_STATED, mount_std_rad=None)
    assumed = identify_recording(replace(made.recording, sensor=sensor, zero_std_rad=None, site=None)).estimate
    assert assumed is not None
    assert (assumed.repeatability.std < 1.1 * certain.repeatability.std).all()
    assert assumed.std[0] > 20.0 * certain.std[0]
    first = {each.code for each in assumed.budget.assumptions(assumed.determined)[:2]}
    assert first == {"estimation-assumed-gain", "estimation-assumed-crosstalk"}


def test_the_covariance_is_the_budgets() -> None:
    _, estimate = found(CLEAN, 0)
    assert isinstance(estimate.budget, Budget)
    np.testing.assert_allclose(estimate.covariance, estimate.budget.covariance)


def test_the_strength_settles_at_the_variance_that_nuisances_have() -> None:
    """Twenty of them, each seen with a noise of 0.1, are drawn with a standard deviation of 0.5."""
    rng = np.random.default_rng(0)
    seen = 0.5 * rng.normal(size=20) + 0.1 * rng.normal(size=20)
    strength = 1.0
    for _ in range(100):
        posterior = 1.0 / (1.0 / 0.01 + 1.0 / strength)
        strength = improve_strength(strength, posterior / 0.01 * seen, posterior * np.eye(20))
    assert strength == pytest.approx(np.mean(seen**2) - 0.01, rel=1e-3)
    assert find_evidence(strength, posterior / 0.01 * seen, posterior * np.eye(20)) > 50.0


def test_what_the_data_say_nothing_of_keeps_its_strength() -> None:
    assert improve_strength(0.7, np.zeros(3), 0.7 * np.eye(3)) == 0.7
