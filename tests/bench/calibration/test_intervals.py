"""`bench.calibration.intervals`: how far intervals of a known world are too narrow is found, and then they hold the truth."""

from __future__ import annotations

import numpy as np
import pytest

from bench.calibration.intervals import find_held, find_held_left_out, find_widened
from bench.calibration.trial import Trial
from core.array import Array
from tests.bench.calibration.test_learning import trial

MOVED, STD = 1.0, 1e-3
EXCESS = 50.0


def world(narrow: float, left: float, count: int = 120) -> tuple[list[Trial], dict[int, Array]]:
    """Trials whose explanation moved the payload by 1, leaves a share of the gap's square, and states an uncertainty so many times too
    small."""
    rng = np.random.default_rng(3)
    trials = []
    for seed in range(count):
        made = trial(seed, ("a",), EXCESS * left)
        nominal, fit = made.traces
        error = rng.normal(scale=narrow * np.hypot(STD, np.sqrt(left) * MOVED), size=10)
        known = {"payload_std": (STD,) * 10}
        nominal = nominal.model_copy(update=known | {"payload_error": tuple(error + MOVED)})
        fit = fit.model_copy(update=known | {"payload_error": tuple(error)})
        trials.append(made.model_copy(update={"traces": (nominal, fit)}))
    return trials, {each.seed: np.array([0.0, 0.1, 0.9]) for each in trials}


@pytest.mark.parametrize(
    ("narrow", "left"), [(1.3, 0.0), (3.0, 0.04), *(pytest.param(*each, marks=pytest.mark.thorough) for each in ((1.3, 0.04), (3.0, 0.0)))]
)
def test_by_how_much_intervals_are_too_narrow_is_found_and_then_they_hold(narrow: float, left: float) -> None:
    trials, told = world(narrow, left)
    found = find_widened(trials, told)
    assert found == pytest.approx(narrow, rel=0.12)
    assert find_held(trials, told, found) == pytest.approx(0.95, abs=0.01)
    assert find_held_left_out(trials, told) == pytest.approx(0.95, abs=0.02)
    assert find_held(trials, told, 1.0) < 0.9


def test_intervals_that_are_wide_enough_stay_as_they_are() -> None:
    assert find_widened(*world(0.8, left=0.04)) == 1.0


def test_trials_of_older_files_tell_nothing_of_it() -> None:
    old = [trial(seed, ("a",), 1.0) for seed in range(8)]
    told = {each.seed: np.array([0.0, 0.1, 0.9]) for each in old}
    assert find_widened(old, told) == 1.0
    assert find_held_left_out(old, told) is None
