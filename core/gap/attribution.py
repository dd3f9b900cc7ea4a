"""Which effect: probabilities over the effects, none and unknown, and what this recording cannot tell apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.gap.effect_fit import EffectFit
from core.gap.tie import Tie, find_ties
from core.gap.weighing import count, find_left_share, read_figures, score, weigh
from core.gap.windows import Windows

FOLLOWS = 1.0
"""Logarithm of the odds by which a shape that merely follows the course of a run has to be more probable than one that does not."""


@dataclass(frozen=True)
class Attribution:
    """Probabilities, which sum to 1.

    Args:
        none, unknown: of no effect, and of one that the library does not have.
        explained: the fits with their probabilities, most probable first.
        ties: among the probable ones.
        unexplained: share of the excess that the best fit leaves over on unseen motions.
    """

    none: float
    unknown: float
    explained: tuple[tuple[EffectFit, float], ...]
    ties: tuple[Tie, ...]
    unexplained: float


def attribute(windows: Windows, nominal: EffectFit, fits: list[EffectFit], kept: NDArray[np.bool_] | None = None) -> Attribution:
    """Weighs the fits against each other and against the nominal twin; by the rows kept (K,) alone, where not all are to count."""
    best = min(fits, key=lambda fit: fit.chi_square, default=nominal)
    weighed = [fit if kept is None else fit.judged_by(kept) for fit in (nominal, *fits)]
    none, unknown, shares = probabilities(weighed[0], weighed[1:])
    explained = tuple(sorted(zip(fits, shares, strict=True), key=lambda pair: -pair[1]))
    unit = max(1.0, float(np.sqrt(best.held_out.mean())))
    return Attribution(none, unknown, explained, find_ties(windows, [fit for fit, _ in explained], unit), find_left_share(nominal, best))


def choose_variants(nominal: EffectFit, fits: list[EffectFit]) -> list[EffectFit]:
    """One fit for each name: of the shapes of an effect the one that is more probable, which is the smaller where both predict alike, and
    one that merely follows the course of a run, which no twin can take, only where it is so by more than `FOLLOWS`."""
    follows = np.array([not all(p.shown for p in fit.parameters) for fit in fits], dtype=float)
    scores = score(count(nominal, fits), read_figures().figures)[1:] - FOLLOWS * follows
    chosen: dict[str, EffectFit] = {}
    for k in np.argsort(-scores, kind="stable"):
        chosen.setdefault(fits[k].name, fits[k])
    return list(chosen.values())


def probabilities(nominal: EffectFit, fits: list[EffectFit]) -> tuple[float, float, list[float]]:
    """Of no effect, of one that the library does not have, and of each fit; they sum to 1."""
    none, unknown, *shares = weigh(nominal, fits).tolist()
    return none, unknown, shares
