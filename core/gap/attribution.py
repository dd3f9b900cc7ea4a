"""Which effect: probabilities over the effects, none and unknown, and what this recording cannot tell apart.

Judged by predictions of motions that a fit did not see. No model is ever exactly right, so chi-square is counted in units of
what the best model leaves over (a quasi-likelihood): the thousands of sigmas of a large gap then do not decide for whichever model
bends best.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit, softmax

from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows

Array = NDArray[np.float64]

INSEPARABLE_SIGMA = 3.0
NONE_PRIOR = 3.0
"""Of no effect, against each single one."""
PAIR_PRIOR = 0.001
"""Of two effects at once, against one."""
BEND = 0.5
"""Of the logarithm of the independent draws that each of the first `STIFF` parameters costs; 1/2 is Schwarz's criterion."""
BENT = 0.001
"""Share of the gap that each further parameter of a wrong model may take up by bending."""
STIFF = 6
BLOCKS = 10.0
"""Independent draws that a model's own error is worth: a run has about as many different motions."""
CHANCE_SIGMA = 3.0
"""Chi-square within this many standard deviations of its mean is chance."""
BENDS = 3
"""A rival with this many parameters more than the first is its generalisation, not its rival."""
UNEXPLAINED_HALF = 0.1
"""Share of the excess that the best model leaves over at which `unknown` is as probable as not."""
UNEXPLAINED_WIDTH = 0.5
"""Of that transition, in the logarithm of the share."""


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
    scale = misfit(best)
    excess = float(nominal.held_out.sum()) - nominal.held_out.size
    scores = np.array([_score(fit, best, scale, excess) for fit in (nominal, *fits)])
    none, *shares = softmax(scores).tolist()
    unexplained = leftover(nominal, best)
    unknown = (1.0 - none) * float(expit((np.log(max(unexplained, 1e-4)) - np.log(UNEXPLAINED_HALF)) / UNEXPLAINED_WIDTH))
    keep = 1.0 - unknown
    explained = tuple(sorted(((fit, share * keep) for fit, share in zip(fits, shares, strict=True)), key=lambda pair: -pair[1]))
    return Attribution(none * keep, unknown, explained, _ties(windows, nominal, explained, best), unexplained)


def _score(fit: EffectFit, best: EffectFit, scale: float, excess: float) -> float:
    """Log weight: how much worse than the best it predicts, less what its parameters cost, so that of two that predict alike the smaller
    one wins. The nominal twin is no approximation: what it predicts worse counts in full."""
    worse = float((fit.held_out - best.held_out).sum())
    unit = max(1.0, float(best.held_out.mean()))
    if not fit.effects:
        return float(np.log(NONE_PRIOR)) - 0.5 * worse / unit
    few, more = min(len(fit.theta), STIFF), max(0, len(fit.theta) - STIFF)
    draws = best.held_out.size * unit / scale
    second = (len(fit.effects) - 1) * float(np.log(PAIR_PRIOR))
    return second - 0.5 * (worse + BENT * more * max(0.0, excess)) / scale - BEND * few * float(np.log(draws))


def misfit(fit: EffectFit) -> float:
    """Chi-square that counts as one. What the best model leaves over beyond chance is its own error, which repeats itself from sample to
    sample: all of it is worth `BLOCKS` independent draws."""
    return 1.0 + max(0.0, beyond_chance(fit)) * fit.held_out.size / BLOCKS


def leftover(nominal: EffectFit, fit: EffectFit) -> float:
    """Share of the nominal twin's excess over noise that a fit leaves on unseen motions; what may be chance does not count."""
    before = float(nominal.held_out.mean()) - 1.0
    return max(0.0, beyond_chance(fit)) / max(before, 1e-9)


def beyond_chance(fit: EffectFit) -> float:
    """Chi-square per row that is left over, less what chance may leave."""
    return float(fit.held_out.mean()) - 1.0 - CHANCE_SIGMA * float(np.sqrt(2.0 / fit.held_out.size))


def _ties(windows: Windows, nominal: EffectFit, explained: tuple[tuple[EffectFit, float], ...], best: EffectFit) -> tuple[Tie, ...]:
    """Rivals of the most probable single effect, their distance in units of what the best model gets wrong."""
    singles = [fit for fit, _ in explained if len(fit.effects) == 1]
    if not singles:
        return ()
    first, unit = singles[0], max(1.0, float(np.sqrt(best.held_out.mean())))
    rivals = [fit for fit in singles[1:] if len(fit.theta) <= len(first.theta) + BENDS]
    ties = [Tie(first, fit, distance_sigma(windows, nominal, first, fit) / unit) for fit in rivals]
    return tuple(sorted((tie for tie in ties if tie.distance_sigma < INSEPARABLE_SIGMA), key=lambda tie: tie.distance_sigma))


def distance_sigma(windows: Windows, nominal: EffectFit, a: EffectFit, b: EffectFit) -> float:
    """Distance of two predictions, after payload, offsets and small imperfections have made up for what they can."""
    difference = (a.change - b.change).ravel()
    seen = windows.X.reshape(len(difference), -1).T @ difference
    return float(np.sqrt(max(0.0, float(difference @ difference - seen @ nominal.covariance @ seen))))
