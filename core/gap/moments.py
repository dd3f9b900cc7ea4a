"""Where what an effect leaves of the gap lies in few motions: how it went there is not quite as its model has it, but what it is fits."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from core.gap.attribution import attribute
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence
from core.gap.weighing import is_in_doubt
from core.words.message import Message

FEW = 0.15
"""Share of the rows that those motions may be."""
MOST = 0.5
"""Share of what the best effect leaves that has to lie in them; and of the gap, that has to lie outside of them."""


def spare_moments(evidence: Evidence) -> Evidence | None:
    """The evidence weighed without the few motions in which the best effect leaves most of what it leaves; None where it does not, or the
    gap itself is made of such moments, or its cause outside of them is unknown as well."""
    nominal, fits = evidence.nominal, [*evidence.singles, *evidence.joined]
    if not fits:
        return None
    best = min(fits, key=lambda fit: fit.chi_square)
    left, gap = _excess(best), _excess(nominal)
    moments = find_moments(left, evidence.windows.group)
    if left[moments].sum() < MOST * left.sum() or gap[~moments].sum() < MOST * gap.sum():
        return None
    if is_in_doubt(*(fit.judged_by(~moments) for fit in (nominal, *fits))):
        return None
    spared = replace(evidence, attribution=attribute(evidence.windows, nominal, fits, ~moments))
    at_s = float(evidence.windows.centres[np.argmax(left)])
    return replace(
        spared, limits=(Message.of("gap-moments-left", share=float(left[moments].sum() / left.sum()), at_s=at_s), *spared.limits)
    )


def find_moments(left: NDArray[np.float64], group: NDArray[np.int64]) -> NDArray[np.bool_]:
    """(K,), rows of the few motions with the most of what is left (K,), each row's motion being told by its number (K,)."""
    moments = np.zeros(len(left), dtype=bool)
    for motion in np.argsort(-np.bincount(group, weights=left)):
        wider = moments | (group == motion)
        if wider.mean() > FEW:
            break
        moments = wider
    return moments


def _excess(fit: EffectFit) -> NDArray[np.float64]:
    """(K,), chi-square of each row beyond noise."""
    return np.asarray((fit.held_out - 1.0).sum(axis=0))
