"""Right and wrong, and what counts."""

from __future__ import annotations

import pytest

from core.trial.bound import Bound
from core.trial.judgement import (
    counts,
    exact_pair,
    find_named_effects,
    forecast,
    gives_right_verdict,
    mark,
    material,
    names_truth_alone,
    right,
    tells_truth_outright,
    truth_class,
)
from core.trial.outcome import Named, ParameterEstimate, TrialOutcome
from tests.core.trial.synthetic_outcomes import double, estimates, none, payload, sealed, single, unknown

SMALL = Bound(fault_sigma=20.0, material_sigma=50.0)
NOISY = {"sensor_noise": {"fx_noise_factor": ParameterEstimate(value=2.0, std=0.02)}}
FAINT = Bound(fault_sigma=5.0, material_sigma=2.0)


def test_a_run_without_a_fault_is_answered_by_no_gap_alone():
    assert right(none(0))
    assert not right(none(0, "explained"))
    assert counts(none(0))


def test_the_first_name_or_a_declared_tie_that_holds_the_truth_is_right():
    assert right(single(0, "time_delay", "time_delay"))
    assert not right(single(0, "time_delay", "sensor_lowpass"))
    assert right(single(0, "time_delay", "sensor_lowpass", verdict="ambiguous", ties=((("sensor_lowpass", "time_delay"), 1.2),)))
    assert not right(single(0, "time_delay", "time_delay", verdict="unknown"))


def test_a_verdict_of_unknown_with_the_right_name_in_its_list_is_not_right_nor_is_a_pair_with_a_wrong_second():
    pair = single(0, "time_delay", "time_delay", pairs=((("sensor_gain", "time_delay"), 0.95),))
    assert not right(single(0, "time_delay", "time_delay", verdict="unknown"))
    assert not names_truth_alone(single(0, "time_delay", "time_delay", verdict="unknown"))
    assert not right(pair)
    assert not names_truth_alone(pair)
    assert names_truth_alone(single(0, "time_delay", "time_delay"))


def test_a_declared_tie_that_holds_the_truth_does_not_name_it():
    tied = single(0, "time_delay", "sensor_lowpass", verdict="ambiguous", ties=((("sensor_lowpass", "time_delay"), 1.2),))
    assert right(tied)
    assert not names_truth_alone(tied)


def test_a_name_is_told_outright_by_explained_alone():
    first_of_open = single(0, "time_delay", "time_delay", verdict="ambiguous")
    assert names_truth_alone(first_of_open)
    assert not tells_truth_outright(first_of_open)
    assert tells_truth_outright(single(0, "time_delay", "time_delay"))
    assert not tells_truth_outright(single(0, "time_delay", "sensor_lowpass"))
    assert not tells_truth_outright(single(0, "time_delay", "time_delay", pairs=((("sensor_gain", "time_delay"), 0.95),)))


def test_what_is_read_off_is_told_outright_beside_no_gap_alone():
    assert tells_truth_outright(beside())
    assert names_truth_alone(beside(verdict="unknown"))
    assert not tells_truth_outright(beside(verdict="unknown"))
    assert not tells_truth_outright(beside(also={}))


@pytest.mark.parametrize(
    ("outcome", "is_right"),
    [
        (none(0), True),
        (none(0, "unknown"), False),
        (single(0, "time_delay", "sensor_lowpass"), True),
        (single(0, "time_delay", "time_delay", verdict="unknown"), False),
        (single(0, "time_delay", "time_delay", bound=SMALL), False),
        (unknown(0), True),
        (unknown(0, "explained"), False),
    ],
)
def test_a_verdict_is_of_the_right_kind_whatever_it_names(outcome: TrialOutcome, is_right: bool):
    assert gives_right_verdict(outcome) is is_right


def test_an_immaterial_fault_is_rightly_passed_over_and_does_not_count():
    passed = single(0, "time_delay", "time_delay", bound=SMALL, verdict="no_gap", effects=(), none_probability=1.0)
    assert not material(passed)
    assert right(passed)
    assert not counts(passed)
    assert truth_class(passed) == "none"
    assert mark(passed).code == "trial-right-does-not-count"


def test_a_material_fault_that_is_passed_over_is_a_failure():
    assert not right(single(0, "time_delay", "time_delay", verdict="no_gap", effects=()))


def test_a_fault_that_nothing_can_see_does_not_count():
    assert not counts(single(0, "time_delay", "time_delay", bound=FAINT))
    assert counts(single(0, "time_delay", "time_delay"))


def test_unknown_counts_only_where_no_effect_of_the_library_describes_it():
    assert counts(unknown(0))
    assert right(unknown(0))
    assert not right(unknown(0, "explained"))
    assert not right(unknown(0, "no_gap"))
    assert not counts(unknown(0, undescribed_sigma=2.0))
    assert not counts(unknown(0, material_sigma=500.0))
    assert right(unknown(0, "no_gap", material_sigma=500.0))


def test_two_faults_are_named_by_exactly_the_pair():
    assert right(double(0, ("base_tilt", "time_delay")))
    assert not right(double(0, ("base_tilt", "sensor_gain")))
    assert find_named_effects(double(0, ("time_delay", "base_tilt"))) == {"base_tilt", "time_delay"}


def test_of_two_faults_one_that_is_read_off_is_to_stand_beside_the_verdict():
    one = {"pairs": (), "effects": (Named(id="base_tilt", probability=0.9, closure=1.0),)}
    tilted_and_noisy = {"sealed": sealed(0, "base_tilt", "sensor_noise", kind="double")}
    assert not exact_pair(double(0, ("base_tilt", "time_delay"), **one).model_copy(update=tilted_and_noisy))
    assert exact_pair(double(0, ("base_tilt", "time_delay"), **one, also=NOISY).model_copy(update=tilted_and_noisy))
    assert not exact_pair(double(0, ("base_tilt", "time_delay"), **one, minor=("time_delay",)))


def beside(**more: object) -> TrialOutcome:
    """Of noise alone, which the verdict does not name."""
    return single(0, "sensor_noise", "sensor_noise", bound=Bound(), **{"verdict": "no_gap", "effects": (), "also": NOISY} | more)


@pytest.mark.parametrize("verdict", ["no_gap", "unknown"])
def test_what_is_read_off_is_right_where_it_stands_beside_with_its_parameters_and_no_other_name_does(verdict: str):
    assert right(beside(verdict=verdict))
    assert truth_class(beside(verdict=verdict)) == "none"
    assert not right(beside(verdict=verdict, also={}))
    assert not right(beside(verdict=verdict, also={"sensor_noise": {}}))
    assert not right(beside(verdict=verdict, also={**NOISY, "payload_mismatch": NOISY["sensor_noise"]}))


def test_another_name_in_the_verdict_is_not_right_for_what_is_read_off():
    creep = (Named(id="sensor_creep", probability=0.9, closure=1.0),)
    assert not right(beside(verdict="explained", effects=creep))
    assert not names_truth_alone(beside(verdict="explained", effects=creep))
    assert names_truth_alone(beside())


def test_noise_that_does_not_matter_is_rightly_passed_over():
    faint = {"sensor_noise": {"fx_noise_factor": 1.2}}
    assert right(beside(also={}, truth=faint))
    assert not right(beside(also={}, truth={"sensor_noise": {"fx_noise_factor": 2.0}}))


def test_something_material_beside_a_run_without_a_fault_is_a_false_alarm():
    assert not right(none(0, also=NOISY))


def test_a_second_fault_that_does_not_show_is_not_asked_for():
    weak = Bound(fault_sigma=100.0, material_sigma=50.0, second_sigma=2.0, second_material=False)
    one = double(0, ("base_tilt", "time_delay"), pairs=(), bound=weak)
    assert not counts(one)
    assert right(one)
    assert truth_class(one) == "base_tilt"


def test_a_trial_without_an_answer_is_not_right_and_does_not_count():
    stopped = TrialOutcome(sealed=sealed(3, "time_delay"), stopped="TooClose: ...", verdict="stopped")
    assert not right(stopped)
    assert not counts(stopped)


@pytest.mark.parametrize(("factor", "matters"), [(1.1, False), (2.0, True)])
def test_noise_is_material_by_its_own_measure(factor: float, matters: bool):
    truth = {"sensor_noise": {"fx_noise_factor": factor}}
    assert material(single(0, "sensor_noise", "sensor_noise", bound=Bound(), truth=truth)) is matters


@pytest.mark.parametrize(("added", "matters"), [(0.2, False), (0.4, True)])
def test_coarse_steps_are_material_by_what_they_add_to_the_readings(added: float, matters: bool):
    outcome = single(0, "sensor_quantization", "sensor_quantization", bound=Bound(added_noise=added))
    assert material(outcome) is matters
    assert counts(outcome) is matters
    assert material(single(0, "sensor_quantization", "sensor_quantization", bound=Bound()))


def test_what_the_seal_tells_goes_before_what_was_added():
    """Of noise as stated times 1.1 the two runs may differ by much, draws of it being others."""
    truth = {"sensor_noise": {"fx_noise_factor": 1.1}}
    assert not material(single(0, "sensor_noise", "sensor_noise", bound=Bound(added_noise=1.4), truth=truth))


def test_a_mismatch_is_material_by_the_shares_of_the_payload():
    for share, matters in ((0.005, False), (0.05, True)):
        truth = {"payload_mismatch": {"m_difference_kg": 2.0 * share, **{f"{k}": 0.0 for k in range(9)}}}
        outcome = single(0, "payload_mismatch", "payload_mismatch", bound=Bound(), truth=truth, payload=payload(0.0, 0.0, 0.001))
        assert material(outcome) is matters


def test_a_forecast_holds_every_class_and_sums_to_one():
    told = forecast(double(0, ("time_delay", "base_tilt")))
    assert told["base_tilt+time_delay"] == 0.9
    assert sum(told.values()) == pytest.approx(1.0)
    assert truth_class(double(0, ("time_delay", "base_tilt"))) == "base_tilt+time_delay"
    assert estimates(delay_s=(0.01, 0.001))["delay_s"].std == 0.001
