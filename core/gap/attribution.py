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

from core.array import Array
from core.gap.effect_fit import EffectFit
from core.gap.tie import Tie, find_ties
from core.gap.windows import Windows

NONE_PRIOR = 3.0
"""Of no effect, against each single one."""
PAIR_PRIOR = 0.001
"""Of a further effect at once, against none."""
BEND = 0.5
"""Of the logarithm of the independent draws that each of the first `STIFF` parameters costs; 1/2 is Schwarz's criterion."""
BENT = 0.001
"""Share of the gap that each further parameter of a wrong model may take up by bending; it costs no more than that."""
STIFF = 6
BLOCKS = 10.0
"""Independent draws that a model's own error is worth: a run has about as many different motions."""
CHANCE_SIGMA = 3.0
"""Chi-square within this many standard deviations of its mean is chance."""
LAPSE = 0.08
"""Share of answers that the evidence calls certain and that are wrong all the same, though nothing is left over: a fault had a shape that
no model has, and another model bent to it."""
BENT_LAPSE = 0.4
"""The same where a remainder shows that the model is only roughly of the right shape: so may be another one."""
BENT_HALF = 0.005
"""Share of the excess left over half way from the one to the other. These three, and `UNKNOWN_MOST`, were chosen on 119 blind trials with a
gap (seeds 20000-20305) for what is left over by single effects."""
UNEXPLAINED_HALF = 0.1
"""Share of the excess that the best model leaves over half way to `unknown`. Two effects bend twice: together they may leave its square."""
UNKNOWN_MOST = 0.65
"""Probability of `unknown` where nothing explains the gap: the rest are effects of the library in another shape than its models."""
WIDTH = 0.5
"""Of these transitions, in the logarithm of the share."""


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
    best = _best(nominal, fits)
    none, unknown, shares = probabilities(nominal, fits)
    explained = tuple(sorted(zip(fits, shares, strict=True), key=lambda pair: -pair[1]))
    unit = max(1.0, float(np.sqrt(best.held_out.mean())))
    return Attribution(none, unknown, explained, find_ties(windows, [fit for fit, _ in explained], unit), leftover(nominal, best))


def choose_variants(nominal: EffectFit, fits: list[EffectFit]) -> list[EffectFit]:
    """One fit for each name: of the shapes of an effect the one that is more probable, which is the smaller where both predict alike."""
    best = _best(nominal, fits)
    excess = float(nominal.held_out.sum()) - nominal.held_out.size
    chosen: dict[str, EffectFit] = {}
    for fit in sorted(fits, key=lambda fit: -_score(fit, best, misfit(best), excess)):
        chosen.setdefault(fit.name, fit)
    return list(chosen.values())


def probabilities(nominal: EffectFit, fits: list[EffectFit]) -> tuple[float, float, list[float]]:
    """Of no effect, of one that the library does not have, and of each fit; they sum to 1.

    So far as two effects together leave more than they may, the single ones are judged as if no two had been fitted.
    """
    single = np.array([len(fit.effects) == 1 for fit in fits], dtype=bool)
    best = _best(nominal, fits)
    weights = _weigh(nominal, fits, np.ones(len(fits), dtype=bool))
    if len(best.effects) > 1:
        doubt = rise(leftover(nominal, best), UNEXPLAINED_HALF ** len(best.effects))
        weights = (1.0 - doubt) * weights + doubt * _weigh(nominal, fits, single)
    none, unknown, *shares = weights.tolist()
    return none, unknown, shares


def _weigh(nominal: EffectFit, fits: list[EffectFit], trusted: NDArray[np.bool_]) -> Array:
    """(2 + len(fits),), probabilities of none, of unknown and of each fit; fits that are not trusted have none."""
    best = _best(nominal, [fit for fit, is_trusted in zip(fits, trusted, strict=True) if is_trusted])
    left, scale = leftover(nominal, best), misfit(best)
    excess = float(nominal.held_out.sum()) - nominal.held_out.size
    scores = np.array([_score(fit, best, scale, excess) for fit in (nominal, *fits)])
    lapse = find_lapse(left)
    others = np.append(not trusted.any(), trusted)
    shares = (1.0 - lapse) * softmax(np.where(np.append(True, trusted), scores, -np.inf)) + lapse * others / others.sum()
    unknown = (1.0 - shares[0]) * find_unknown(left)
    return np.insert((1.0 - unknown) * shares, 1, unknown)


def find_lapse(left: float) -> float:
    """Share of answers that are wrong although the evidence calls them certain, where a share `left` of the excess is left over."""
    return LAPSE + (BENT_LAPSE - LAPSE) * rise(left, BENT_HALF)


def find_unknown(left: float) -> float:
    """Probability of `unknown` where there is an effect and the best explanation leaves a share `left` of the excess over."""
    return UNKNOWN_MOST * rise(left, UNEXPLAINED_HALF)


def rise(share: float, half: float) -> float:
    """From 0 to 1 with the logarithm of a share of the excess, 1/2 at `half`."""
    return float(expit(np.log(max(share, 1e-4) / half) / WIDTH))


def _best(nominal: EffectFit, fits: list[EffectFit]) -> EffectFit:
    """What predicts unseen motions best; the nominal twin where nothing was fitted."""
    return min(fits, key=lambda fit: fit.held_out.sum(), default=nominal)


def _score(fit: EffectFit, best: EffectFit, scale: float, excess: float) -> float:
    """Log weight: how much worse than the best it predicts, less what its parameters cost, so that of two that predict alike the smaller
    one wins. The nominal twin is no approximation: what it predicts worse counts in full."""
    worse = float((fit.held_out - best.held_out).sum())
    unit = max(1.0, float(best.held_out.mean()))
    if not fit.effects:
        return float(np.log(NONE_PRIOR)) - 0.5 * worse / unit
    few, more = min(fit.free, STIFF), max(0, fit.free - STIFF)
    draws = best.held_out.size * unit / scale
    schwarz = BEND * float(np.log(draws))
    further = min(schwarz, 0.5 * BENT * max(0.0, excess) / scale)
    second = (len(fit.effects) - 1) * float(np.log(PAIR_PRIOR))
    return second - 0.5 * worse / scale - few * schwarz - more * further


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
