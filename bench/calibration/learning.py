"""The figures that make trials most probable, held back by a prior; and the same with one group of trials left out after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from bench.calibration.mattering import learn_mattering
from bench.calibration.trial import Trial
from core.array import Array
from core.gap.weighing import Contest, count, find_mattering, weigh_numbers

PRIOR = {
    "log_draws": (np.log(10.0), 1.0),
    "schwarz": (0.5, 0.15),
    "log_bent": (np.log(0.001), 1.0),
    "none": (np.log(3.0), 1.0),
    "further": (np.log(1000.0), 2.0),
    "unknown": (-2.6, 1.5),
    "unknown_left": (1.5, 1.0),
    "mimicked": (-3.5, 1.0),
    "lapse": (-2.2, 0.7),
    "lapse_left": (0.8, 0.5),
}
"""Mean and standard deviation of each figure before any trial: a run has some ten different motions, parameters cost by Schwarz's
criterion. Wide, but for that price, of which trials tell little."""
STEP = 1e-4
"""Of numerical derivatives, in standard deviations of the prior."""
FOLDS = 5
DRAWN = 12
"""Starts drawn from the prior beside its mean: the cost has several valleys."""


class Cases(NamedTuple):
    """Trials as they are learnt from: their numbers, padded to the same length, and the places (T,) of the truths among none, unknown and
    the fits."""

    numbers: Contest
    truths: NDArray[np.intp]


def can_teach(trial: Trial) -> bool:
    """Whether there is something to learn: what was planted matters and was noticed, or nothing was planted."""
    return (trial.matters and trial.material) or not trial.families


def find_truth(trial: Trial) -> int:
    """Place of the truth among none, which what does not matter is too, unknown and the fits; what no fit stands for is unknown."""
    if not trial.matters:
        return 0
    names = [sorted(trace.name.split("+")) for trace in trial.traces[1:]]
    return next((2 + k for k, name in enumerate(names) if name == sorted(trial.families)), 1)


def stack(trials: Sequence[Trial]) -> Cases:
    """Behind each other."""
    return stack_each([count(trial.traces[0], trial.traces[1:]) for trial in trials], [find_truth(trial) for trial in trials])


def stack_each(each: Sequence[Contest], truths: Sequence[int]) -> Cases:
    """Recordings behind each other, with the place of the truth in each."""
    most = max(len(numbers.chi_square) for numbers in each)
    chi_square, free, further = (
        np.array([np.pad(numbers[k], (0, most - len(numbers[k])), constant_values=fill) for numbers in each])
        for k, fill in enumerate((np.inf, 0.0, 0.0))
    )
    least, rows = (np.array([numbers[k] for numbers in each]) for k in (3, 4))
    return Cases(Contest(chi_square, free, further, least, rows), np.array(truths))


def learn(cases: Cases, start: dict[str, float] | None = None) -> dict[str, float]:
    """The most probable figures under the prior."""
    mean, std = (np.array(values) for values in zip(*PRIOR.values(), strict=True))
    each = np.arange(len(cases.truths))

    def cost(v: Array) -> float:
        p = weigh_numbers(cases.numbers, dict(zip(PRIOR, mean + std * v, strict=True)))
        return float(-np.log(np.maximum(p[each, cases.truths], 1e-12)).sum()) + 0.5 * float(v @ v)

    def slope(v: Array) -> Array:
        return np.array([(cost(v + STEP * way) - cost(v - STEP * way)) / (2.0 * STEP) for way in np.eye(len(v))])

    drawn = np.random.default_rng(0).normal(size=(DRAWN, len(mean)))
    begins = [np.zeros(len(mean)), *drawn] if start is None else [(np.array([start[name] for name in PRIOR]) - mean) / std]
    found = min(
        (minimize(cost, begin, jac=slope, method="L-BFGS-B", options={"maxiter": 100}) for begin in begins), key=lambda end: end.fun
    )
    return dict(zip(PRIOR, (mean + std * found.x).tolist(), strict=True))


def group_of(trial: Trial) -> str:
    """Trials that are left out together: one variant, one unknown cause; the rest in folds."""
    if len(trial.families) == 1:
        return f"{trial.families[0]}:{trial.variants[0]}"
    return f"{len(trial.families)}:{trial.seed % FOLDS}"


class LeftOut(NamedTuple):
    """By seed, probabilities of each trial by figures that were learnt without its group: of what is there, and of what is told, where what
    does not matter counts as none."""

    there: dict[int, Array]
    told: dict[int, Array]


def predict_left_out(trials: Sequence[Trial]) -> LeftOut:
    """Learnt from the other groups, one after the other."""
    whole = learn(stack([trial for trial in trials if can_teach(trial)]))
    found = LeftOut({}, {})
    for group in sorted({group_of(trial) for trial in trials}):
        others = [trial for trial in trials if group_of(trial) != group]
        rest, matters = [trial for trial in others if can_teach(trial)], learn_mattering(others)
        figures = learn(stack(rest), whole) if rest else whole
        for trial in trials:
            if group_of(trial) == group:
                there = weigh_numbers(count(trial.traces[0], trial.traces[1:]), figures)
                mattering = float(find_mattering(np.array(trial.margins, dtype=float), matters, float(there[1])))
                found.there[trial.seed] = there
                found.told[trial.seed] = np.append(1.0 - mattering * (1.0 - there[0]), mattering * there[1:])
    return found
