"""What the payload is once the gap is explained: averaged over the explanations, each by its probability.

Hoeting et al., Bayesian model averaging: a tutorial, Statistical Science 14 (1999): what the explanations disagree about widens the
intervals as what each leaves open does. Of the mixture the shortest interval counts that holds 95 %: a rival that is improbable and far
away widens it a little, and not by its distance, as it does a standard deviation.

What an explanation leaves of the gap may have moved the payload as well, and such an error is not seen in any residual: the payload has
taken it up. It is counted in proportion: what is left of the gap, a tenth of its size, moves the payload by a tenth of what the rest did.
"""

from __future__ import annotations

import numpy as np
from scipy.special import ndtr

from core.array import Array
from core.estimation.determination import find_determined
from core.gap.answer import INTERVAL, PhiPart
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence
from core.gap.weighing import find_left_share

HELD = 0.95
"""Of the mixture, by an interval."""
LEAST = 1e-6
"""Probability below which an explanation moves no end of an interval."""
REACH = np.linspace(-5.0, 5.0, 201)
"""Where each explanation's distribution is looked at, in its standard deviations."""
BELOW = np.linspace(0.0, 1.0 - HELD, 101)
"""Of the mixture, below an interval."""


def describe_payload_after(evidence: Evidence) -> PhiPart:
    """The payload with the middles of the intervals as values; that of the nominal twin where no effect is probable."""
    nominal = evidence.nominal
    if not evidence.best.effects:
        phi, std = nominal.phi, nominal.phi_std
    else:
        told = [*evidence.attribution.explained, (nominal, evidence.attribution.none)]
        probable = [(fit, p) for fit, p in told if p > LEAST]
        share = np.array([p for _, p in probable])
        each = np.array([fit.phi for fit, _ in probable])
        own = np.array([np.hypot(fit.phi_std, _find_hidden(nominal, fit)) for fit, _ in probable])
        phi, std = average(share / share.sum(), each, own)
    return PhiPart(phi=phi.tolist(), std=std.tolist(), determined=find_determined(phi, std).tolist())


def _find_hidden(nominal: EffectFit, fit: EffectFit) -> Array:
    """(10,), standard uncertainty by what the fit leaves of the gap."""
    return np.asarray(np.sqrt(find_left_share(nominal, fit)) * np.abs(fit.phi - nominal.phi))


def average(share: Array, phi: Array, std: Array) -> tuple[Array, Array]:
    """Middle (n,) and standard uncertainty (n,) of the shortest interval that holds 95 % of normal distributions about phi (k, n) with std
    (k, n), in shares (k,) that sum to 1; the uncertainty is that of a normal distribution with such an interval."""
    ends = np.array([_find_shortest(share, *each) for each in zip(phi.T, std.T, strict=True)])
    return ends.mean(axis=1), (ends[:, 1] - ends[:, 0]) / (2.0 * INTERVAL)


def _find_shortest(share: Array, mean: Array, std: Array) -> Array:
    """(2,), ends of the shortest interval that holds 95 % of a mixture of normal distributions, (k,) each."""
    x = np.sort((mean + np.multiply.outer(REACH, std)).ravel())
    held = ndtr((x[:, None] - mean) / std) @ share
    first, last = np.interp(BELOW, held, x), np.interp(BELOW + HELD, held, x)
    shortest = int(np.argmin(last - first))
    return np.array([first[shortest], last[shortest]])
