"""Learning from trials: weights of a known world come back, and sets hold the truth as often as they are to."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from bench.calibration.learning import PRIOR, Cases, can_teach, find_truth, group_of, learn, stack
from bench.calibration.scores import find_calibration_error, find_coverage, is_right, score
from bench.calibration.trial import Trial
from core.array import Array
from core.gap.weighing import weigh_numbers
from tests.core.gap.test_weighing import trace


def trial(seed: int, families: tuple[str, ...], *lefts: float, material: bool = True, matters: bool | None = None) -> Trial:
    """Of a gap of 50; fits `a`, `b`, ... leave so much. What is planted matters if nothing else is said."""
    fits = [trace(chr(97 + k), left) for k, left in enumerate(lefts)]
    return Trial(
        seed=seed,
        families=families,
        variants=tuple(f"shape_{seed % 10}" for _ in families),
        size=1.0,
        gap=7.0,
        matters=bool(families) if matters is None else matters,
        material=material,
        margins=(3.5, 2.0, 0.0) if material else (0.5, 0.5, 0.0),
        traces=(trace("none", 50.0 if families else 0.0), *fits),
        seconds=1.0,
        version="",
    )


def test_the_figures_of_a_known_world_are_found() -> None:
    rng = np.random.default_rng(4)
    lefts = 50.0 * 10.0 ** rng.uniform(-4.0, 0.0, (600, 2))
    world = {name: mean for name, (mean, _) in PRIOR.items()} | {"unknown": 0.5, "unknown_left": 0.8, "lapse": -1.0}
    numbers = stack([trial(seed, ("a",), *left) for seed, left in enumerate(lefts)]).numbers
    truths = np.array([rng.choice(4, p=p) for p in weigh_numbers(numbers, world)])
    found = learn(Cases(numbers, truths))
    assert found["unknown"] == pytest.approx(0.5, abs=0.3)
    assert found["unknown_left"] == pytest.approx(0.8, abs=0.3)


def test_with_nothing_to_learn_from_what_was_known_before_stays() -> None:
    silent = stack([trial(0, ())])
    found = learn(Cases(silent.numbers, np.array([0])))
    assert found == pytest.approx({name: mean for name, (mean, _) in PRIOR.items()}, abs=0.3)


def test_the_deepest_of_several_valleys_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    mean, std = PRIOR["log_draws"]

    def two_valleys(_: object, figures: Mapping[str, float]) -> Array:
        away = (figures["log_draws"] - mean) / std
        return np.exp(-20.0 * np.array([[min(away**2 + 1.0, (away - 2.0) ** 2)]]))

    monkeypatch.setattr("bench.calibration.learning.weigh_numbers", two_valleys)
    found = learn(Cases(stack([trial(0, ())]).numbers, np.array([0])))
    assert found["log_draws"] == pytest.approx(mean + 2.0 * std, abs=0.1 * std)


def test_what_no_fit_stands_for_is_unknown() -> None:
    assert find_truth(trial(0, ("b",), 1.0, 2.0)) == 3
    assert find_truth(trial(0, ("c",), 1.0, 2.0)) == 1
    assert find_truth(trial(0, ("unknown",), 1.0)) == 1
    assert find_truth(trial(0, (), 1.0)) == 0
    assert find_truth(trial(0, ("b",), 1.0, 2.0, matters=False)) == 0


def test_a_verdict_is_right_by_name_and_nothing_else() -> None:
    p = np.array([0.0, 0.2, 0.5, 0.3])
    assert is_right(trial(0, ("a",), 1.0, 2.0), p)
    assert not is_right(trial(0, ("b",), 1.0, 2.0), p)
    no_gap = np.array([0.7, 0.2, 0.05, 0.05])
    assert not is_right(trial(0, ("a",), 1.0, 2.0), no_gap)
    assert is_right(trial(0, (), 1.0, 2.0), no_gap)
    assert is_right(trial(0, ("unknown",), 1.0, 2.0), np.array([0.0, 0.6, 0.3, 0.1]))


def test_trials_of_one_variant_are_left_out_together() -> None:
    assert group_of(trial(1, ("a",))) == group_of(trial(11, ("a",)))
    assert group_of(trial(1, ("a",))) != group_of(trial(1, ("b",)))
    assert not can_teach(trial(1, ("a",), material=False))


def test_probabilities_that_are_right_as_often_as_they_say_have_no_calibration_error() -> None:
    rng = np.random.default_rng(5)
    first = rng.uniform(0.5, 1.0, 4000)
    trials = [trial(seed, ("a",) if rng.random() < p else ("b",), 1.0, 1.0) for seed, p in enumerate(first)]
    told = {seed: np.array([0.0, 0.0, p, 1.0 - p]) for seed, p in enumerate(first)}
    assert find_calibration_error(trials, told) < 0.03
    assert find_calibration_error(trials, {seed: np.array([0.0, 0.0, 1.0, 0.0]) for seed in told}) > 0.2
    covered, size = find_coverage(trials[:400], told)
    assert covered == pytest.approx(0.9, abs=0.04)
    assert 1.0 <= size <= 2.0
    assert score(trials[:200], told).named[1] == 200
