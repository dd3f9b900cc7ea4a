"""Which explanations a cell's twin takes: one rule for who adds an effect and for who only offers to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from core.effects.effect import Effect
from core.errors import BadTwin
from core.gap.closure import closure_of, gap_of
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence

SEEN_SIGMA = 2.0
"""An effect none of whose parameters is farther than this from its absent value, in its own uncertainty, is not determined."""


def why_not_addable(evidence: Evidence, fit: EffectFit) -> str | None:
    """What stands against adding the effects of a fit to the twin; None where nothing does."""
    try:
        check_shown(evidence, fit.effects, "")
        check_addable(evidence, fit, "")
    except BadTwin as reason:
        return reason.found
    return None


def check_shown(evidence: Evidence, effects: Sequence[Effect], where: str) -> None:
    """The recording can show the effects, and what it shows of them holds in other runs.

    Raises:
        BadTwin: not so; `where` is what was diagnosed.
    """
    scene = evidence.windows.basis.scene.with_phi(evidence.nominal.phi)
    for effect in effects:
        if reason := effect.explain_absence(scene):
            raise BadTwin(where, f"a recording that cannot show {effect.id} ({reason})", "one that can")
        if reason := effect.explain_tie_to_run(scene):
            raise BadTwin(where, f"a recording from which {effect.id} cannot be carried over ({reason})", "one that states it")


def check_addable(evidence: Evidence, fit: EffectFit, where: str) -> None:
    """The gap is smaller with the effects, and each of them is determined.

    Raises:
        BadTwin: not so; `where` is what was diagnosed.
    """
    check_closure(evidence, fit, where)
    for effect, rows in split_parameter_rows(evidence, fit):
        away = np.abs(fit.theta[rows] - [p.absent for p in fit.parameters[rows]]) / fit.theta_std[rows]
        if away.max() < SEEN_SIGMA:
            found = f"{effect.id} not determined: no parameter is more than {away.max():.1f} standard deviations from its absence"
            raise BadTwin(where, found, f"at least {SEEN_SIGMA:g}; a longer or livelier run shows more")


def check_closure(evidence: Evidence, fit: EffectFit, where: str) -> None:
    """The gap is smaller with the effects.

    Raises:
        BadTwin: not for certain.
    """
    closure, (low, _) = closure_of(evidence.windows, evidence.nominal, fit)
    if low > 0.0:
        return
    before, after = gap_of(evidence.windows, evidence.nominal), gap_of(evidence.windows, fit)
    found = f"{fit.name} closing {100 * closure:.0f} % of the gap ({before:.3f} before, {after:.3f} after, noise is 1)"
    raise BadTwin(where, found, "an effect that makes the gap smaller for certain; `heft diagnose` names those that do")


def split_parameter_rows(evidence: Evidence, fit: EffectFit) -> Iterator[tuple[Effect, slice]]:
    """Each effect of a fit with the rows of its parameters."""
    begin = 0
    for effect in fit.effects:
        rows = slice(begin, begin + len(effect.parameters(evidence.windows.basis.scene)))
        yield effect, rows
        begin = rows.stop
