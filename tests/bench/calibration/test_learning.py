"""Learning from trials: weights of a known world come back, and sets hold the truth as often as they are to."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import softmax

from bench.calibration.by_hand import weigh_by_hand
from bench.calibration.learning import Case, can_teach, find_truth, group_of, learn
from bench.calibration.scores import find_calibration_error, find_coverage, is_right, score
from bench.calibration.trial import Trial
from tests.bench.calibration.test_weighing import trace

TRUE = np.array([1.5, -1.0, 0.0])


def cases(count: int) -> list[Case]:
    """Answers with three features each, drawn as a world with the true weights would."""
    rng = np.random.default_rng(4)
    rows = rng.normal(size=(count, 8, 3))
    return [Case(row, int(rng.choice(8, p=softmax(row @ TRUE)))) for row in rows]


def trial(seed: int, families: tuple[str, ...], *lefts: float, material: bool = True) -> Trial:
    """Of a gap of 50; fits `a`, `b`, ... leave so much."""
    fits = [trace(chr(97 + k), left) for k, left in enumerate(lefts)]
    return Trial(
        seed=seed,
        families=families,
        variants=tuple(f"shape_{seed % 10}" for _ in families),
        size=1.0,
        gap=7.0,
        matters=bool(families),
        material=material,
        traces=(trace("none", 50.0 if families else 0.0), *fits),
        seconds=1.0,
        version="",
    )


def test_the_weights_of_a_known_world_are_found() -> None:
    assert learn(cases(1500)) == pytest.approx(TRUE, abs=0.15)


def test_with_nothing_to_learn_from_all_answers_are_alike() -> None:
    assert learn([Case(np.ones((3, 3)), 0)]) == pytest.approx(np.zeros(3), abs=1e-6)


def test_what_no_fit_stands_for_is_unknown() -> None:
    assert find_truth(trial(0, ("b",), 1.0, 2.0)) == 3
    assert find_truth(trial(0, ("c",), 1.0, 2.0)) == 1
    assert find_truth(trial(0, ("unknown",), 1.0)) == 1
    assert find_truth(trial(0, (), 1.0)) == 0


def test_a_verdict_is_right_by_name_and_nothing_else() -> None:
    p = np.array([0.0, 0.2, 0.5, 0.3])
    assert is_right(trial(0, ("a",), 1.0, 2.0), p)
    assert not is_right(trial(0, ("b",), 1.0, 2.0), p)
    assert not is_right(trial(0, ("a",), 1.0, 2.0, material=False), p)
    assert is_right(trial(0, (), 1.0, 2.0, material=False), p)
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


def test_figures_chosen_by_hand_are_probabilities_too() -> None:
    p = weigh_by_hand(trace("none", 50.0), [trace("a", 0.0), trace("b", 30.0)])
    assert p.sum() == pytest.approx(1.0)
    assert np.argmax(p) == 2
