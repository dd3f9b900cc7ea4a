"""What one recording cannot tell apart: two explanations of which one follows whatever the other predicts.

A rival is fitted anew to the prediction of the first, which has no noise, with payload, offsets and small imperfections free; what it
cannot follow is the distance. Two fits to the same noisy recording stand further apart than what they say: each bends to the noise
with all parameters that it has to spare.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass

import numpy as np

from core.gap.effect_fit import ITERATIONS, EffectFit, descend
from core.gap.problem import Problem
from core.gap.windows import Windows

INSEPARABLE_SIGMA = 3.0
SWAY_SIGMA = 3.0
"""The noise may speak for or against a rival by this many standard deviations."""
BENDS = 3
"""A rival with this many parameters more than the first is its generalisation, not its rival."""


@dataclass(frozen=True)
class Tie:
    """Two explanations that this recording cannot tell apart.

    Args:
        first, second: the fits.
        distance_sigma: what the second cannot follow of the first, in standard deviations of what counts as noise.
    """

    first: EffectFit
    second: EffectFit
    distance_sigma: float


def find_ties(windows: Windows, explained: Sequence[EffectFit], unit: float) -> tuple[Tie, ...]:
    """Rivals of the most probable explanation, of as many effects, the nearest first.

    Args:
        explained: most probable first.
        unit: standard deviation that counts as noise, in those of the noise: what the best model gets wrong.

    A rival at distance d is worse on the recording by d^2 in the mean, with a standard deviation of 2 d; those that are worse by more
    than that allows for a tie are not fitted anew.
    """
    if not explained:
        return ()
    first = explained[0]
    most = float((first.residual**2).sum()) + ((INSEPARABLE_SIGMA + SWAY_SIGMA) * unit) ** 2
    alike = [fit for fit in explained[1:] if len(fit.effects) == len(first.effects) and fit.free <= first.free + BENDS]
    rivals = [fit for fit in alike if float((fit.residual**2).sum()) <= most]
    ties = [Tie(first, fit, distance_sigma(windows, first, fit) / unit) for fit in rivals]
    return tuple(sorted((tie for tie in ties if tie.distance_sigma < INSEPARABLE_SIGMA), key=lambda tie: tie.distance_sigma))


def distance_sigma(windows: Windows, first: EffectFit, rival: EffectFit) -> float:
    """What a rival, fitted anew, cannot follow of the first one's prediction, in standard deviations of the noise.

    Small imperfections that the rival needs beyond those of the first count by their priors; the size of an effect does not.
    """
    predicted = copy(windows)
    predicted.target = windows.target - first.residual
    problem = Problem(predicted, rival.effects)
    cost, _, theta = descend(problem, rival.beta, rival.theta, iterations=ITERATIONS)
    of_beta, of_theta = np.split(problem.precision, [len(first.beta)])
    size = theta - problem.absent
    return float(np.sqrt(max(0.0, cost - size @ (of_theta * size) - first.beta @ (of_beta * first.beta))))
