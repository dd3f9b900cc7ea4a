"""`bench.calibration.intervals`: what hides in the payload of a known world is found, and intervals then hold the truth."""

from __future__ import annotations

import numpy as np
import pytest

from bench.calibration.intervals import find_held, find_held_left_out, find_hidden
from bench.calibration.trial import Trial
from core.array import Array
from tests.bench.calibration.test_learning import trial

MOVED, STD = 1.0, 1e-3
EXCESS = 50.0


def world(hidden: float, left: float, count: int = 120) -> tuple[list[Trial], dict[int, Array]]:
    """Trials whose explanation moved the payload by 1, leaves a share of the gap's square, and is wrong by `hidden` times its root."""
    rng = np.random.default_rng(3)
    trials = []
    for seed in range(count):
        made = trial(seed, ("a",), EXCESS * left)
        nominal, fit = made.traces
        error = rng.normal(scale=np.hypot(STD, hidden * np.sqrt(left) * MOVED), size=10)
        known = {"payload_std": (STD,) * 10}
        nominal = nominal.model_copy(update=known | {"payload_error": tuple(error + MOVED)})
        fit = fit.model_copy(update=known | {"payload_error": tuple(error)})
        trials.append(made.model_copy(update={"traces": (nominal, fit)}))
    return trials, {each.seed: np.array([0.0, 0.1, 0.9]) for each in trials}


@pytest.mark.parametrize("hidden", [0.5, 2.0])
def test_what_hides_in_the_payload_is_found_and_intervals_hold(hidden: float) -> None:
    trials, told = world(hidden, left=0.04)
    found = find_hidden(trials, told)
    assert found == pytest.approx(hidden, rel=0.15)
    assert find_held(trials, told, found) == pytest.approx(0.95, abs=0.01)
    left_out = find_held_left_out(trials, told)
    assert left_out == pytest.approx(0.95, abs=0.02)
    assert find_held(trials, told, 0.0) < 0.5


def test_where_nothing_hides_nothing_is_added() -> None:
    trials, told = world(0.0, left=0.04)
    assert find_hidden(trials, told) < 0.05


def test_trials_of_older_files_tell_nothing_of_it() -> None:
    old = [trial(seed, ("a",), 1.0) for seed in range(8)]
    told = {each.seed: np.array([0.0, 0.1, 0.9]) for each in old}
    assert find_hidden(old, told) == 1.0
    assert find_held_left_out(old, told) is None
