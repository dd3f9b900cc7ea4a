"""A series in the words of ISO 5725, and its verdict."""

from __future__ import annotations

import numpy as np
import pytest

from core.errors import BadInput
from core.payload.random_effects import Measured
from core.payload.series import analyse_variance, compare_series, student_factor
from core.payload.uncertain_parameters import UncertainParameters

TRUTH = np.array([2.8, 0.0, -0.047, 0.1, 0.007, 0.0, 0.0, 0.0066, 0.0017, 0.0033])
STD = np.array([1e-4, *[3e-5] * 3, *[5e-6] * 6])


def runs(count: int, between: float, seed: int = 0) -> list[Measured]:
    rng = np.random.default_rng(seed)
    drawn = [TRUTH + STD * (rng.normal(size=10) + between * rng.normal(size=10)) for _ in range(count)]
    return [Measured(UncertainParameters(phi, np.diag(STD**2))) for phi in drawn]


def test_the_analysis_of_variance_is_that_of_the_standard_s_formulas() -> None:
    values = np.array([10.0, 12.0, 20.0, 22.0])
    repeatability, between, reproducibility = analyse_variance(values, ["a", "a", "b", "b"])
    # within: 2 and 2 on one degree of freedom each; means 11 and 21, mean square 100, less 2, over 2 runs each
    assert repeatability == pytest.approx(np.sqrt(2.0))
    assert between == pytest.approx(np.sqrt(49.0))
    assert reproducibility == pytest.approx(np.sqrt(51.0))


def test_without_a_repetition_there_is_no_repeatability_and_with_one_condition_no_reproducibility() -> None:
    assert analyse_variance(np.array([1.0, 3.0]), ["a", "b"]) == (None, None, pytest.approx(np.sqrt(2.0)))
    assert analyse_variance(np.array([1.0, 3.0]), ["a", "a"]) == (pytest.approx(np.sqrt(2.0)), None, None)
    assert analyse_variance(np.array([1.0]), ["a"]) == (None, None, None)


def test_a_series_that_scatters_as_it_says_agrees_and_one_that_does_not_says_by_how_much() -> None:
    agrees = compare_series(list("abcd"), runs(4, 0.0))
    assert not agrees.differ and agrees.verdict.code == "payload-series-agrees" and not any(pair.differ for pair in agrees.pairs)
    differs = compare_series(list("abcdef"), runs(6, 8.0))
    assert differs.differ and differs.verdict.code == "payload-series-differs"
    assert 2.5e-5 < differs.parameters[4].unstated_std < 6e-5  # 8 times 5e-6
    assert "kg" in differs.verdict.text and differs.verdict.say("de").startswith("Die 6 Läufe")


def test_one_run_that_is_off_is_named_with_the_parameter_and_of_two_none_is() -> None:
    made = runs(5, 0.0)
    heavier = made[2].own.phi + np.array([0.031, *[0.0] * 9])
    made[2] = Measured(UncertainParameters(heavier, made[2].own.covariance))
    found = compare_series(list("abcde"), made)
    assert found.differ and found.apart is not None
    assert (found.apart.run, found.apart.parameter, found.apart.unit) == ("c", "m", "kg")
    # a mean of four with one of its own: five quarters of one run's variance
    assert found.apart.std == pytest.approx(1e-4 * np.sqrt(1.25))
    assert found.apart.difference == pytest.approx(0.031, abs=5 * found.apart.std)
    assert compare_series(list("ab"), made[1:3]).apart is None
    assert compare_series(list("abc"), [made[0], *made[3:]]).apart is None
    two_off = [*made, Measured(UncertainParameters(made[0].own.phi - 0.05, made[0].own.covariance))]
    assert compare_series(list("abcdef"), two_off).apart is None


def test_conditions_of_another_number_of_runs_are_refused() -> None:
    with pytest.raises(BadInput, match="one for each of the 2 runs"):
        compare_series(["a", "b"], runs(2, 0.0), conditions=["x"])


def test_runs_that_determine_nothing_are_refused() -> None:
    nothing = Measured(UncertainParameters(np.full(10, np.nan), np.full((10, 10), np.nan)))
    with pytest.raises(BadInput, match="determine nothing"):
        compare_series(["a"], [nothing])


def test_a_single_run_is_its_own_answer() -> None:
    found = compare_series(["a"], runs(1, 0.0))
    assert found.verdict.code == "payload-series-of-one" and found.chance is None
    assert found.parameters[0].half_width == pytest.approx(1.96e-4)


@pytest.mark.parametrize("freedom", [1, 2, 3, 4, 7, 12, 30, 61])
def test_intervals_are_students(freedom: int) -> None:
    from scipy.stats import t

    assert student_factor(freedom) == pytest.approx(t.ppf(0.975, freedom), rel=1e-9)
