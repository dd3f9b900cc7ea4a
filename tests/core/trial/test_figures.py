"""Every figure of the sheet, from outcomes that are made up so that the answer is known."""

from __future__ import annotations

import numpy as np
import pytest

from core.trial.bound import Bound
from core.trial.figures import (
    Share,
    all_answers,
    calibration_error,
    calibration_error_by_chance,
    closure_ratios,
    first_answers,
    fit_halfway_size,
    parameter_errors,
    payload_errors,
    reliability,
    share_right,
    tie_honesty,
)
from core.trial.outcome import Named
from tests.core.trial.synthetic_outcomes import CLEAR, double, estimates, none, payload, single, unknown

NEAR = CLEAR.model_copy(update={"nearest_rival_sigma": 1.0})


def test_wilsons_interval_is_that_of_the_literature():
    # Newcombe 1998, Statistics in Medicine 17, table I: 81 of 263 is 0.2553 to 0.3662; 0 of 20 is 0 to 0.1611
    assert Share(81, 263).interval == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert Share(0, 20).interval == pytest.approx((0.0, 0.1611), abs=5e-5)
    assert np.isnan(Share(0, 0).value)


def test_only_trials_that_count_enter_a_share():
    faint = single(2, "time_delay", "base_tilt", bound=Bound(fault_sigma=4.0, material_sigma=1.0))
    found = share_right([single(0, "time_delay", "time_delay"), single(1, "time_delay", "base_tilt"), faint, none(3)], "single")
    assert (found.hits, found.of) == (1, 2)
    assert share_right([unknown(0), unknown(1, "explained")], "unknown").value == 0.5
    assert share_right([double(0, ("base_tilt", "time_delay"))], "double").value == 1.0


def test_ties_are_to_be_declared_below_three_sigma_and_not_above_six():
    tie = ((("base_tilt", "time_delay"), 1.0),)
    declared, one_name = tie_honesty([
        single(0, "time_delay", "base_tilt", bound=NEAR, ties=tie),
        single(1, "time_delay", "base_tilt", bound=NEAR),
        single(2, "time_delay", "time_delay"),
        single(3, "time_delay", "time_delay", ties=tie),
    ])  # fmt: skip
    assert (declared.hits, declared.of) == (1, 2)
    assert (one_name.hits, one_name.of) == (1, 2)


def test_calibrated_answers_have_no_calibration_error():
    rng = np.random.default_rng(5)
    p = rng.uniform(0, 1, 40000)
    assert calibration_error(reliability(p, rng.uniform(size=len(p)) < p)) < 0.01
    assert calibration_error(reliability(p, rng.uniform(size=len(p)) < p**2)) == pytest.approx(1 / 6, abs=0.01)


@pytest.mark.parametrize("count", [25, 400])
def test_few_calibrated_answers_seem_to_be_off_by_what_chance_is_told_to_make(count: int):
    rng = np.random.default_rng(6)
    p = rng.uniform(0.5, 1.0, count)
    low, high = calibration_error_by_chance(p)
    errors = np.array([calibration_error(reliability(p, rng.uniform(size=count) < p)) for _ in range(1000)])
    assert 0.92 < np.mean((low <= errors) & (errors <= high)) < 0.98
    assert not low <= calibration_error(reliability(p, np.zeros(count, dtype=bool))) <= high


def test_answers_of_none_and_unknown_are_part_of_the_calibration():
    outcomes = [none(0), single(1, "time_delay", "base_tilt", 0.7), unknown(2)]
    probability, hit = first_answers(outcomes)
    assert probability == pytest.approx([1.0, 0.7, 1.0])
    assert hit.tolist() == [True, False, True]
    probability, hit = all_answers(outcomes, 0.01)
    assert sorted(probability) == pytest.approx([0.3, 0.7, 1.0, 1.0])
    assert int(hit.sum()) == 3


def test_closure_is_compared_with_the_true_effects():
    assert closure_ratios([single(0, "time_delay", "base_tilt"), single(1, "base_tilt", "base_tilt")]) == [(1.0, 0.95), (0.95, 0.95)]


def test_parameters_count_when_they_are_determined_and_intervals_always():
    found = Named(
        id="base_tilt",
        probability=0.9,
        closure=1.0,
        parameters=estimates(about_x_rad=(0.0102, 0.0002), about_y_rad=(0.0, 0.0002), loose=(3.0, 1.0)),
    )
    truth = {"base_tilt": {"about_x_rad": 0.01, "about_y_rad": 0.0005, "loose": 2.5}}
    errors, covered = parameter_errors([single(0, "base_tilt", "base_tilt", effects=(found,), truth=truth)])
    assert errors == pytest.approx([0.02])
    assert (covered.hits, covered.of) == (2, 3)
    small = Bound(fault_sigma=10.0, material_sigma=1.0)
    assert parameter_errors([single(0, "base_tilt", "base_tilt", effects=(found,), truth=truth, bound=small)])[0] == []


def test_payload_errors_are_shares_of_mass_moment_and_inertia():
    found = payload_errors([single(0, "base_tilt", "base_tilt", payload=payload(0.03, 0.002, 0.0015))])
    assert found.before == pytest.approx(0.03, rel=1e-6)
    assert found.after == pytest.approx(0.002, rel=1e-6)
    assert found.stated == pytest.approx(0.0015, rel=1e-6)
    assert found.covered == Share(10, 10)
    assert payload_errors([single(0, "base_tilt", "time_delay", payload=payload(0.1, 0.1, 0.1))]).covered.of == 0


def test_half_of_the_trials_are_named_where_the_curve_was_drawn_from():
    rng = np.random.default_rng(2)
    x = np.exp(rng.uniform(np.log(0.3), np.log(30.0), 3000))
    hit = rng.uniform(size=len(x)) < 1 / (1 + (3.0 / x) ** 2)
    assert fit_halfway_size(x.tolist(), hit.tolist()) == pytest.approx(3.0, rel=0.1)
    assert fit_halfway_size([1.0, 2.0], [True, True]) is None
    assert 2.0 < (fit_halfway_size([1.0, 2.0, 4.0, 8.0], [False, False, True, True]) or 0.0) < 4.0
