"""What the payload is once the gap is explained: averaged over the explanations, each by its probability.

Hoeting et al., Bayesian model averaging: a tutorial, Statistical Science 14 (1999): what the explanations disagree about widens the
intervals as what each leaves open does. Of the mixture the shortest interval counts that holds 95 %: a rival that is improbable and far
away widens it a little, and not by its distance, as it does a standard deviation.

What an explanation leaves of the gap may have moved the payload as well, and such an error is not seen in any residual: the payload has
taken it up. It is counted in proportion: what is left of the gap, a tenth of its size, moves the payload by a tenth of what the explanation
did. And no model has quite the shape of its cause: by how much all that has to be wider where a gap matters, simulated trials tell
(`Figures.widened`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.special import ndtr

from core.array import Array
from core.estimation.determination import find_determined
from core.gap.answer import INTERVAL, PhiPart
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence
from core.gap.weighing import find_left_share, read_figures

HELD = 0.95
"""Of the mixture, by an interval."""
LEAST = 1e-4
"""Probability below which an explanation moves no end of an interval."""
REACH = np.linspace(-5.0, 5.0, 201)
"""Where each explanation's distribution is looked at, in its standard deviations."""
BELOW = np.linspace(0.0, 1.0 - HELD, 101)
"""Of the mixture, below an interval."""


def describe_payload_after(evidence: Evidence) -> PhiPart:
    """The payload with the middles of the intervals as values; that of the nominal twin where no effect is probable."""
    nominal = evidence.nominal
    if not evidence.best.effects:
        return describe_phi(nominal.phi, nominal.phi_std)
    explained = [*evidence.attribution.explained, (nominal, evidence.attribution.none)]
    return describe_average(nominal, explained, read_figures().widened if evidence.material else 1.0)


def describe_average(nominal: EffectFit, explained: Sequence[tuple[EffectFit, float]], widened: float) -> PhiPart:
    """The payload of several explanations of what the nominal twin leaves, each with its probability (see `average`)."""
    fits, p = zip(*explained, strict=True)
    left = np.array([find_left_share(nominal, fit) for fit in fits])
    phi, std = (np.array([getattr(fit, name) for fit in fits]) for name in ("phi", "phi_std"))
    return describe_phi(*average(np.array(p), phi, std, left, nominal.phi, widened))


def describe_phi(phi: Array, std: Array) -> PhiPart:
    """A payload with its standard uncertainty, (10,) each, and what of it is determined."""
    return PhiPart(phi=phi.tolist(), std=std.tolist(), determined=find_determined(phi, std).tolist())


def average(p: Array, phi: Array, std: Array, left: Array, nominal: Array, widened: float) -> tuple[Array, Array]:
    """Middle (n,) and standard uncertainty (n,) of the shortest interval that holds 95 %, as a normal distribution with such an interval
    has them.

    Args:
        p: (k,), probabilities of the explanations; where they sum to less than 1, the rest is shared among them.
        phi, std: (k, n), what each makes of the payload.
        left: (k,), share of the gap's square that each leaves.
        nominal: (n,), the payload without any.
        widened: factor on each explanation's uncertainty.
    """
    probable = p > LEAST
    share, mean, moved = p[probable] / p[probable].sum(), phi[probable], np.abs(phi[probable] - nominal)
    own = widened * np.hypot(std[probable], np.sqrt(left[probable])[:, None] * moved)
    ends = np.array([_find_shortest(share, *each) for each in zip(mean.T, own.T, strict=True)])
    return ends.mean(axis=1), (ends[:, 1] - ends[:, 0]) / (2.0 * INTERVAL)


def _find_shortest(share: Array, mean: Array, std: Array) -> Array:
    """(2,), ends of the shortest interval that holds 95 % of a mixture of normal distributions, (k,) each."""
    x = np.sort((mean + np.multiply.outer(REACH, std)).ravel())
    held = ndtr((x[:, None] - mean) / std) @ share
    first, last = np.interp(BELOW, held, x), np.interp(BELOW + HELD, held, x)
    shortest = int(np.argmin(last - first))
    return np.array([first[shortest], last[shortest]])
