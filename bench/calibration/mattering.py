"""How probable it is that what is there matters, learnt from what it was found to be: a logistic regression for each measure, where either
is enough."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from bench.calibration.trial import Trial
from core.array import Array
from core.gap.weighing import MEASURES, find_mattering

Figures = dict[str, tuple[float, float]]

PRIOR = {"gap": ((0.0, 0.5), (30.0, 10.0)), "moved": ((0.0, 1.0), (4.0, 2.0)), "reference": ((0.0, 1.0), (4.0, 2.0))}
"""Mean and standard deviation of each figure before any trial: a gap is known to a few per cent, what moves the payload to a quarter."""


def learn_mattering(trials: Sequence[Trial]) -> Figures:
    """The most probable figures under the prior; a background alone never matters. What an explanation moves is learnt as if no trial had a
    reference: where there is one it is not asked for."""
    margins = np.array([trial.margins for trial in trials], dtype=float).reshape(-1, len(MEASURES))
    truths = np.array([trial.matters for trial in trials])
    told = _learn(margins, truths, ("gap", "reference"), {name: (at[0], by[0]) for name, (at, by) in PRIOR.items()})
    margins[:, MEASURES.index("reference")] = np.nan
    return _learn(margins, truths, ("moved",), told)


def _learn(margins: Array, truths: NDArray[np.bool_], wanted: tuple[str, ...], known: Figures) -> Figures:
    """The wanted figures anew, the others as they are known."""
    mean, std = np.array([PRIOR[name] for name in wanted]).transpose(2, 0, 1)

    def figures_of(v: Array) -> Figures:
        return known | {name: (float(at), float(by)) for name, (at, by) in zip(wanted, mean + std * v.reshape(mean.shape), strict=True)}

    def cost(v: Array) -> float:
        p = find_mattering(margins, figures_of(v))
        return float(-np.log(np.clip(np.where(truths, p, 1.0 - p), 1e-12, 1.0)).sum() + 0.5 * v @ v)

    return figures_of(minimize(cost, np.zeros(mean.size), method="L-BFGS-B").x)
