"""Whether what is there matters: a known world comes back, and what was measured against the rules counts."""

from __future__ import annotations

import numpy as np
import pytest

from bench.calibration.learning import predict_left_out
from bench.calibration.mattering import PRIOR, learn_mattering
from bench.calibration.trial import Trial
from core.gap.weighing import find_mattering
from tests.bench.calibration.test_learning import trial

WORLD = {"gap": (0.3, 25.0), "moved": (-1.5, 3.0), "reference": (-1.0, 4.0)}


def trials_of(world: dict[str, tuple[float, float]], *, referred: bool) -> list[Trial]:
    """Of that world, in which the gap and the payload are off by as little as by much; with a reference that tells, or without."""
    rng = np.random.default_rng(3)
    margins = np.exp(rng.normal(0.0, 0.5, (800, 3)))
    if not referred:
        margins[:, 2] = np.nan
    matters = rng.random(len(margins)) < find_mattering(margins, world)
    told = [(gap, moved, off if referred else None) for gap, moved, off in margins.tolist()]
    return [
        trial(seed, ("a",), 1.0, matters=bool(it)).model_copy(update={"margins": each})
        for seed, (it, each) in enumerate(zip(matters, told, strict=True))
    ]


@pytest.mark.parametrize(("referred", "by"), [(True, "reference"), (False, "moved")])
def test_the_figures_of_a_known_world_are_found(referred: bool, by: str) -> None:
    found = learn_mattering(trials_of(WORLD, referred=referred))
    assert found["gap"][1] == pytest.approx(25.0, abs=8.0)
    assert found[by] == pytest.approx(WORLD[by], abs=1.0)


def test_with_nothing_to_learn_from_what_was_known_before_stays() -> None:
    assert learn_mattering([]) == {name: (at[0], by[0]) for name, (at, by) in PRIOR.items()}


def test_either_measure_is_enough_and_a_reference_that_agrees_counts_more_than_an_explanation() -> None:
    margins = [[3.0, 0.0, 0.0], [0.5, 30.0, np.nan], [0.5, 0.0, 30.0], [0.5, 30.0, 0.0], [0.5, 0.0, np.nan], [1.0, 0.0, 0.0]]
    p = find_mattering(np.array(margins), WORLD)
    assert p[:-1] == pytest.approx([1.0, 1.0, 1.0, 0.0, 0.0], abs=0.01)
    assert p[-1] == pytest.approx(1.0 / (1.0 + np.exp(-0.3)), abs=1e-3)


def test_what_an_explanation_moves_counts_as_far_as_it_may_be_the_cause() -> None:
    margins = np.array([[0.5, 30.0, np.nan], [0.5, 0.0, 30.0], [3.0, 0.0, np.nan]])
    p = find_mattering(margins, WORLD, unknown=0.8)
    assert p == pytest.approx([0.2, 1.0, 1.0], abs=0.01)


def test_what_is_told_counts_what_does_not_matter_as_none() -> None:
    trials = trials_of(WORLD, referred=True)[:60]
    there, told = predict_left_out(trials)
    for each in trials:
        assert told[each.seed].sum() == pytest.approx(1.0)
        assert told[each.seed][0] >= there[each.seed][0]
    assert min(told[each.seed][0] for each in trials) < 0.1
    assert max(told[each.seed][0] for each in trials) > 0.5
