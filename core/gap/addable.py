"""Which explanations a cell's twin takes: one rule for who adds an effect and for who only offers to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from core.effects.effect import Effect
from core.gap.addition import Objection
from core.gap.closure import closure_of, gap_of
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence
from core.words.message import Message

SEEN_SIGMA = 2.0
"""An effect none of whose parameters is farther than this from its absent value, in its own uncertainty, is not determined."""


def why_not_addable(evidence: Evidence, fit: EffectFit) -> Message | None:
    """What stands against adding the effects of a fit to the twin; None where nothing does."""
    objection = _object_to_showing(evidence, fit.effects) or _object_to_fit(evidence, fit)
    return None if objection is None else objection.against


def check_shown(evidence: Evidence, effects: Sequence[Effect], where: str) -> None:
    """The recording can show the effects, and what it shows of them holds in other runs.

    Raises:
        BadTwin: not so; `where` is what was diagnosed.
    """
    if objection := _object_to_showing(evidence, effects):
        raise objection.at(where)


def check_addable(evidence: Evidence, fit: EffectFit, where: str) -> None:
    """The gap is smaller with the effects, and each of them is determined.

    Raises:
        BadTwin: not so; `where` is what was diagnosed.
    """
    if objection := _object_to_fit(evidence, fit):
        raise objection.at(where)


def check_closure(evidence: Evidence, fit: EffectFit, where: str) -> None:
    """The gap is smaller with the effects.

    Raises:
        BadTwin: not for certain.
    """
    if objection := _object_to_closure(evidence, fit):
        raise objection.at(where)


def _object_to_showing(evidence: Evidence, effects: Sequence[Effect]) -> Objection | None:
    scene = evidence.windows.basis.scene.with_phi(evidence.nominal.phi)
    for effect in effects:
        if reason := effect.explain_absence(scene):
            return Objection(Message.of("gap-cannot-show", effect=effect.id, reason=reason), Message.of("gap-wanted-shown"))
        if reason := effect.explain_tie_to_run(scene):
            return Objection(Message.of("gap-tied-to-run", effect=effect.id, reason=reason), Message.of("gap-wanted-stated"))
    return None


def _object_to_fit(evidence: Evidence, fit: EffectFit) -> Objection | None:
    if objection := _object_to_closure(evidence, fit):
        return objection
    for effect, rows in split_parameter_rows(evidence, fit):
        away = np.abs(fit.theta[rows] - [p.absent for p in fit.parameters[rows]]) / fit.theta_std[rows]
        if away.max() < SEEN_SIGMA:
            against = Message.of("gap-not-determined", effect=effect.id, away_sigma=float(away.max()))
            return Objection(against, Message.of("gap-wanted-livelier", least_sigma=SEEN_SIGMA))
    return None


def _object_to_closure(evidence: Evidence, fit: EffectFit) -> Objection | None:
    closure, (low, _) = closure_of(evidence.windows, evidence.nominal, fit)
    if low > 0.0:
        return None
    before, after = gap_of(evidence.windows, evidence.nominal), gap_of(evidence.windows, fit)
    against = Message.of("gap-not-closed", effect=fit.name, closure=closure, gap_before=before, gap_after=after)
    return Objection(against, Message.of("gap-wanted-closed"))


def split_parameter_rows(evidence: Evidence, fit: EffectFit) -> Iterator[tuple[Effect, slice]]:
    """Each effect of a fit with the rows of its parameters."""
    begin = 0
    for effect in fit.effects:
        rows = slice(begin, begin + len(effect.parameters(evidence.windows.basis.scene)))
        yield effect, rows
        begin = rows.stop
