"""From evidence to probabilities by a conditional logit whose weights are learnt, `python -m bench.calibration`.

Every fit, `none` and `unknown` has a utility that is linear in a few features of the traces; probabilities are their softmax. The weights
stand in `probabilities.json` beside this file, with where they come from.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import TypeAlias

import numpy as np
from pydantic import BaseModel, ConfigDict
from scipy.special import softmax

from bench.calibration.trace import Trace
from core.array import Array

FILE = Path(__file__).with_name("probabilities.json")
CHANCE_SIGMA = 3.0
"""Chi-square within this many standard deviations of its mean is chance."""
DRAWS = 10.0
"""Independent draws that a model's own error is worth: a run has about as many different motions."""
FEW = 6
"""Parameters that a model is stiff with; the logarithm of the number counts beyond them."""
LEAST_SHARE = 1e-4
"""Of the gap: less than this is nothing left."""
COMPRESSED = 1.0
"""Log-likelihood from which more is hardly any worse."""

Features: TypeAlias = dict[str, float]


class Provenance(BaseModel):
    """Where weights come from: how many trials of which seeds, made by which versions, learnt when, and how they do on what they were not
    learnt from, beside figures that were chosen by hand."""

    model_config = ConfigDict(frozen=True)

    date: str
    trials: int
    learnt_from: int
    seeds: tuple[int, int]
    versions: tuple[str, ...]
    scores: dict[str, float]
    scores_by_hand: dict[str, float]


class Weights(BaseModel):
    """What is learnt.

    Args:
        weights: by feature.
        outside: probability below which an answer is left out of the set that holds the truth in 90 % of all cases.
        overlooked: probability that something matters although the verdict is that nothing does.
    """

    model_config = ConfigDict(frozen=True)

    weights: dict[str, float]
    outside: float
    overlooked: float
    provenance: Provenance


@cache
def read_weights() -> Weights:
    """Those that are shipped."""
    return Weights.model_validate_json(FILE.read_text(encoding="utf-8"))


def weigh(nominal: Trace, fits: Sequence[Trace], weights: dict[str, float] | None = None) -> Array:
    """(2 + n,), probabilities of no effect, of one that the library does not have, and of each of the n fits; they sum to 1."""
    known = read_weights().weights if weights is None else weights
    return np.asarray(softmax([sum(known[name] * value for name, value in row.items()) for row in describe(nominal, fits)]))


def describe(nominal: Trace, fits: Sequence[Trace]) -> list[Features]:
    """Features of no effect, of one that the library does not have, and of each fit."""
    best = min(fits, key=lambda fit: fit.chi_square, default=nominal)
    single = min((fit for fit in fits if fit.effects == 1), key=lambda fit: fit.chi_square, default=nominal)
    scale = 1.0 + beyond_chance(best) * best.rows / DRAWS
    unit = max(1.0, best.chi_square / best.rows)
    none = {"none": 1.0, "none_worse": -_compress(0.5 * (nominal.chi_square - best.chi_square) / unit)}
    return [none, _describe_unknown(nominal, best, single), *(_describe_fit(nominal, fit, best, scale, unit) for fit in fits)]


def _describe_unknown(nominal: Trace, best: Trace, single: Trace) -> Features:
    sigma = max(0.0, best.chi_square / best.rows - 1.0) / math.sqrt(2.0 / best.rows)
    return {
        "unknown": 1.0,
        "unknown_left": math.log10(left_share(nominal, best) + LEAST_SHARE),
        "unknown_mostly": left_share(nominal, best),
        "unknown_left_by_one": math.log10(left_share(nominal, single) + LEAST_SHARE),
        "unknown_sigma": math.log10(1.0 + sigma),
        "unknown_lag": float(np.mean(best.lag)),
        "unknown_bound": float(best.at_bound > 0),
    }


def _describe_fit(nominal: Trace, fit: Trace, best: Trace, scale: float, unit: float) -> Features:
    differences = np.subtract(fit.by_block, best.by_block)
    spread = float(np.std(differences, ddof=1)) * math.sqrt(len(differences))
    draws = best.rows * unit / scale
    return {
        "worse": -_compress(0.5 * (fit.chi_square - best.chi_square) / scale),
        "worse_everywhere": -min(5.0, float(differences.sum()) / max(spread, 1e-9)),
        "left": -math.log10(left_share(nominal, fit) + LEAST_SHARE),
        "few_parameters": -0.5 * min(fit.free, FEW) * math.log(max(draws, 1.0)) / 10.0,
        "more_parameters": -math.log1p(max(0, fit.free - FEW)),
        "bound": -float(fit.at_bound > 0),
        "size": -math.log1p(fit.size),
        "pair": -float(fit.effects > 1),
        "pair_left": -float(fit.effects > 1) * (4.0 + math.log10(left_share(nominal, fit) + LEAST_SHARE)),
    }


def _compress(x: float) -> float:
    """`x` where it is small, by its logarithm where it is large; below zero there is nothing."""
    return COMPRESSED * math.log1p(max(0.0, x) / COMPRESSED)


def beyond_chance(fit: Trace) -> float:
    """Chi-square per row that is left over, less what chance may leave; not below 0."""
    return max(0.0, fit.chi_square / fit.rows - 1.0 - CHANCE_SIGMA * math.sqrt(2.0 / fit.rows))


def left_share(nominal: Trace, fit: Trace) -> float:
    """Share of the nominal twin's excess over noise that a fit leaves on unseen motions; at most 1."""
    return min(1.0, beyond_chance(fit) / max(nominal.chi_square / nominal.rows - 1.0, 1e-9))
