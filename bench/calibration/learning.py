"""The weights that make trials most probable, held back by a prior; and the same with one group of trials left out after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.special import logsumexp, softmax

from bench.calibration.trial import Trial
from bench.calibration.weighing import describe
from core.array import Array

PRIOR_STD = 0.5
"""Of each weight, in units of its feature's spread."""
PRIOR_MEAN = {"worse": 1.0, "none_worse": 1.0, "few_parameters": 3.0, "unknown_left": 2.0, "unknown_mostly": 2.0, "pair": 3.0}
"""Of some weights, zero of the others: the likelihood counts as it is, parameters by a third of Schwarz's criterion."""
FOLDS = 5


class Case(NamedTuple):
    """A trial as it is learnt from: features (1 + 1 + n, f) of none, of unknown and of each fit; which of them is the truth."""

    rows: Array
    truth: int


def can_teach(trial: Trial) -> bool:
    """Whether there is something to learn: what was planted matters and was noticed, or nothing was planted."""
    return (trial.matters and trial.material) or not trial.families


def find_truth(trial: Trial) -> int:
    """Place of the truth among none, unknown and the fits; what no fit stands for is unknown."""
    if trial.truth == "none":
        return 0
    names = [trace.name for trace in trial.traces[1:]]
    ways = {trial.truth, "+".join(reversed(trial.families))}
    return next((2 + k for k, name in enumerate(names) if name in ways), 1)


def list_features(trials: Sequence[Trial]) -> list[str]:
    """Names of all features, sorted."""
    return sorted({name for trial in trials for row in describe(trial.traces[0], trial.traces[1:]) for name in row})


def make_case(trial: Trial, names: list[str]) -> Case:
    """Its features as a matrix."""
    rows = [[row.get(name, 0.0) for name in names] for row in describe(trial.traces[0], trial.traces[1:])]
    return Case(np.array(rows), find_truth(trial))


def learn(cases: Sequence[Case], names: Sequence[str] = (), start: Array | None = None) -> Array:
    """(f,), weights; the most probable ones under a normal prior.

    Args:
        names: of the features, as far as the prior knows them.
        start: where to begin.
    """
    rows, absent, truth = _stack(cases)
    spread = np.maximum(np.concatenate([case.rows for case in cases]).std(axis=0), 1e-3)
    width = PRIOR_STD / spread
    mean = np.array([PRIOR_MEAN.get(name, 0.0) for name in names] or np.zeros(len(width)))
    scaled, each = rows * width, np.arange(len(cases))

    def cost(v: Array) -> tuple[float, Array]:
        utilities = scaled @ v + base - absent
        p = softmax(utilities, axis=1)
        total = float(-np.log(np.maximum(p[each, truth], 1e-300)).sum()) + 0.5 * float(v @ v)
        p[each, truth] -= 1.0
        return total, np.einsum("ta,taf->f", p, scaled) + v

    base = rows @ mean
    v = np.zeros(len(width)) if start is None else (start - mean) / width
    return np.asarray(mean + width * minimize(cost, v, jac=True, method="L-BFGS-B", options={"maxiter": 300}).x)


def _stack(cases: Sequence[Case]) -> tuple[Array, Array, NDArray[np.intp]]:
    """Features (T, A, f) of all answers, what is taken off the utility (T, A) of those that a trial does not have, and the truths (T,)."""
    most = max(len(case.rows) for case in cases)
    rows = np.array([np.pad(case.rows, ((0, most - len(case.rows)), (0, 0))) for case in cases])
    absent = np.array([np.where(np.arange(most) < len(case.rows), 0.0, 1e9) for case in cases])
    return rows, absent, np.array([case.truth for case in cases])


def group_of(trial: Trial) -> str:
    """Trials that are left out together: one variant, one unknown cause; the rest in folds."""
    if len(trial.families) == 1:
        return f"{trial.families[0]}:{trial.variants[0]}"
    return f"{len(trial.families)}:{trial.seed % FOLDS}"


def predict_left_out(trials: Sequence[Trial], names: list[str]) -> dict[int, Array]:
    """By seed, probabilities of each trial by weights that were learnt without its group."""
    cases = {trial.seed: make_case(trial, names) for trial in trials}
    whole = learn([cases[trial.seed] for trial in trials if can_teach(trial)], names)
    found: dict[int, Array] = {}
    for group in sorted({group_of(trial) for trial in trials}):
        w = learn([cases[trial.seed] for trial in trials if group_of(trial) != group and can_teach(trial)], names, whole)
        for trial in trials:
            if group_of(trial) == group:
                u = cases[trial.seed].rows @ w
                found[trial.seed] = np.exp(u - logsumexp(u))
    return found
