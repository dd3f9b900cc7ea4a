"""Probabilities by the figures of `core.gap.attribution`, worked out from traces: learnt ones have to be better."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.special import softmax

from bench.calibration.trace import Trace
from core.array import Array
from core.gap.attribution import (
    BEND,
    BENT,
    BLOCKS,
    CHANCE_SIGMA,
    NONE_PRIOR,
    PAIR_PRIOR,
    STIFF,
    UNEXPLAINED_HALF,
    find_lapse,
    find_unknown,
    rise,
)


def weigh_by_hand(nominal: Trace, fits: Sequence[Trace]) -> Array:
    """(2 + n,), probabilities of none, of unknown and of each fit."""
    every = np.ones(len(fits), dtype=bool)
    best = _best(nominal, fits)
    weights = _weigh(nominal, fits, every)
    if best.effects > 1:
        doubt = rise(_left(nominal, best), UNEXPLAINED_HALF**best.effects)
        weights = (1.0 - doubt) * weights + doubt * _weigh(nominal, fits, np.array([fit.effects == 1 for fit in fits], dtype=bool))
    return weights


def _weigh(nominal: Trace, fits: Sequence[Trace], trusted: NDArray[np.bool_]) -> Array:
    best = _best(nominal, [fit for fit, is_trusted in zip(fits, trusted, strict=True) if is_trusted])
    left, scale = _left(nominal, best), 1.0 + max(0.0, _beyond(best)) * best.rows / BLOCKS
    excess = nominal.chi_square - nominal.rows
    scores = np.array([_score(fit, best, scale, excess) for fit in (nominal, *fits)])
    lapse = find_lapse(left)
    others = np.append(not trusted.any(), trusted)
    shares = (1.0 - lapse) * softmax(np.where(np.append(True, trusted), scores, -np.inf)) + lapse * others / others.sum()
    unknown = (1.0 - shares[0]) * find_unknown(left)
    return np.asarray(np.insert((1.0 - unknown) * shares, 1, unknown))


def _score(fit: Trace, best: Trace, scale: float, excess: float) -> float:
    worse, unit = fit.chi_square - best.chi_square, max(1.0, best.chi_square / best.rows)
    if not fit.effects:
        return float(np.log(NONE_PRIOR)) - 0.5 * worse / unit
    schwarz = BEND * float(np.log(best.rows * unit / scale))
    further = min(schwarz, 0.5 * BENT * max(0.0, excess) / scale)
    costs = min(fit.free, STIFF) * schwarz + max(0, fit.free - STIFF) * further
    return (fit.effects - 1) * float(np.log(PAIR_PRIOR)) - 0.5 * worse / scale - costs


def _best(nominal: Trace, fits: Sequence[Trace]) -> Trace:
    return min(fits, key=lambda fit: fit.chi_square, default=nominal)


def _beyond(fit: Trace) -> float:
    return fit.chi_square / fit.rows - 1.0 - CHANCE_SIGMA * float(np.sqrt(2.0 / fit.rows))


def _left(nominal: Trace, fit: Trace) -> float:
    return max(0.0, _beyond(fit)) / max(nominal.chi_square / nominal.rows - 1.0, 1e-9)
