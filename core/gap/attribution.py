"""Which effect: probabilities over the effects, none and unknown, and what this recording cannot tell apart.

Judged by predictions of motions that a fit did not see. No model is ever exactly right, so chi-square is counted in units of
what the best model leaves over, thinned by the correlation of its residual (a quasi-likelihood): the thousands of sigmas of a
large gap then do not decide for whichever model bends best.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.estimation.generalised_least_squares import correlation_time
from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows

Array = NDArray[np.float64]

INSEPARABLE_SIGMA = 3.0
PAIR_PRIOR = 0.02
"""Of two effects at once, against one."""
NONE_PRIOR = 3.0
"""Of no effect, against each single one."""
BENDS = 3
"""A rival with this many parameters more than the first is its generalisation, not its rival."""
UNEXPLAINED_HALF = 0.25
"""Share of the excess that the best model leaves over at which `unknown` is as probable as not."""
UNEXPLAINED_WIDTH = 0.05


@dataclass(frozen=True)
class Tie:
    """Two explanations that this recording cannot tell apart.

    Args:
        first, second: the fits.
        distance_sigma: between their best versions, orthogonal to payload, offsets and small imperfections.
    """

    first: EffectFit
    second: EffectFit
    distance_sigma: float


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


def attribute(windows: Windows, nominal: EffectFit, fits: list[EffectFit]) -> Attribution:
    """Weighs the fits against each other and against the nominal twin."""
    best = min(fits, key=lambda fit: fit.held_out.sum(), default=nominal)
    spread = misfit(best)
    weights = {fit.name: _log_weight(fit, spread) for fit in [nominal, *fits]}
    largest = max(weights.values())
    raw = {name: np.exp(weight - largest) for name, weight in weights.items()}
    total = sum(raw.values())
    share = {name: float(value / total) for name, value in raw.items()}
    unexplained = leftover(nominal, best)
    unknown = (1.0 - share["none"]) / (1.0 + np.exp(-(unexplained - UNEXPLAINED_HALF) / UNEXPLAINED_WIDTH))
    keep = 1.0 - unknown
    explained = tuple(sorted(((fit, share[fit.name] * keep) for fit in fits), key=lambda pair: -pair[1]))
    return Attribution(share["none"] * keep, float(unknown), explained, _ties(windows, nominal, explained), unexplained)


def misfit(fit: EffectFit) -> float:
    """Chi-square that counts as one: what the fit leaves over per row, times the correlation of its residual."""
    excess = max(1.0, float(fit.held_out.mean()))
    if excess < 1.1:
        return excess
    correlation = np.mean([correlation_time(channel) for channel in fit.residual])
    return excess * max(1.0, float(correlation))


def leftover(nominal: EffectFit, fit: EffectFit) -> float:
    """Share of the nominal twin's excess over noise that a fit leaves on unseen motions."""
    before = float(nominal.held_out.mean()) - 1.0
    return max(0.0, float(fit.held_out.mean()) - 1.0) / max(before, 1e-9)


def _log_weight(fit: EffectFit, spread: float) -> float:
    """Predictive fit, less what each parameter may bend (Schwarz), so that of two that predict alike the smaller one wins."""
    prior = float(np.log(NONE_PRIOR)) if not fit.effects else (len(fit.effects) - 1) * float(np.log(PAIR_PRIOR))
    bends = 0.5 * len(fit.theta) * float(np.log(fit.held_out.size / spread))
    return -0.5 * float(fit.held_out.sum()) / spread - bends + prior


def _ties(windows: Windows, nominal: EffectFit, explained: tuple[tuple[EffectFit, float], ...]) -> tuple[Tie, ...]:
    """Rivals of the most probable single effect."""
    singles = [fit for fit, _ in explained if len(fit.effects) == 1]
    if not singles:
        return ()
    first = singles[0]
    rivals = [fit for fit in singles[1:] if len(fit.theta) <= len(first.theta) + BENDS]
    ties = [Tie(first, fit, distance_sigma(windows, nominal, first, fit)) for fit in rivals]
    return tuple(sorted((tie for tie in ties if tie.distance_sigma < INSEPARABLE_SIGMA), key=lambda tie: tie.distance_sigma))


def distance_sigma(windows: Windows, nominal: EffectFit, a: EffectFit, b: EffectFit) -> float:
    """Distance of two predictions, after payload, offsets and small imperfections have made up for what they can."""
    difference = (a.change - b.change).ravel()
    seen = windows.X.reshape(len(difference), -1).T @ difference
    return float(np.sqrt(max(0.0, float(difference @ difference - seen @ nominal.covariance @ seen))))
