"""Which slip explains what the stated set-up does not: every one is undone, and the simple model fitted again.

The stated set-up is believed unless another explains the same stances several times better, beyond what the number of slips that are tried
gives by chance. Where several do so alike, all of them are named; where none does, none is.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.estimation.setup.agreement import measure_disagreement
from core.estimation.setup.payload_fit import PayloadFit, fit_payload
from core.estimation.setup.slips import slips_of
from core.estimation.setup.stances import Stances
from core.words.message import Message

FEWEST = 4
"""Stances without which nothing is said."""
BAD = 5.0
"""Misfit from which the stated set-up is doubted at all: a tenth of the load's change is left."""
GOOD = 6.0
"""Misfit up to which another set-up explains the stances."""
TIMES_BETTER = 3.0
PRIOR_ODDS = 7.0
"""Logarithm of the odds for the stated set-up against each of the others."""
ALIKE = 1.5
"""Factor between misfits within which two slips are not told apart."""
MOST_NAMED = 3
SEARCHED = 100
"""Stances with which slips are tried: a hundred tell as well as all, three times faster."""
LONGEST_LEVER_M = 1.5
"""No robot carries its payload's centre of mass further away from its wrist."""
CONFLICT = 4.0
"""Misfit and disagreement together from which the kinematics are doubted."""
DISAGREEMENT = 3.5
"""Chi-square of disagreement that counts like a misfit of one."""
MOTION_TIMES_BETTER = 3.0
RARER = 1.3
"""Factor on the misfit for each step of rarity."""


@dataclass(frozen=True)
class SetupExplanation:
    """Slips that explain the stances alike, the likeliest first, and how many times better than the stated set-up."""

    names: tuple[Message, ...]
    times: float


def explain_stances(stances: Stances, stated: PayloadFit) -> SetupExplanation | None:
    """What would be right instead of the stated set-up; None where that fits, or nothing fits better."""
    if stances.distinct < FEWEST or stated.freedom < 1:
        return None
    if stated.misfit < BAD:
        return _explain_sign(stances, stated) if stated.upside_down else None
    tried = [(slip, fit_payload(slip.undo(stances))) for slip in slips_of(stances)]
    freedom = stated.freedom
    enough = [
        (each.misfit * RARER ** (slip.rarity + each.upside_down), _name(slip.name, each), each)
        for slip, each in tried
        if each.misfit < GOOD
        and _is_possible(each)
        and _times(stated, each) > TIMES_BETTER
        and freedom * np.log(_times(stated, each)) > PRIOR_ODDS + np.log(len(tried))
    ]
    if not enough:
        return None
    ranked = sorted(enough, key=lambda found: max(found[0], 1.0))
    leading = [found for found in ranked if max(found[0], 1.0) < ALIKE * max(ranked[0][0], 1.0)][:MOST_NAMED]
    return SetupExplanation(tuple(name for _, name, _ in leading), _times(stated, leading[0][2]))


def explain_motion(stances: Stances, stated: PayloadFit) -> SetupExplanation | None:
    """The same where the weight alone fits and only the motion contradicts it: joints about parallel axes, for example."""
    before = _conflict(stated)
    if before < CONFLICT:
        return None
    stances = stances.thin(SEARCHED)
    before = _conflict(fit_payload(stances))
    tried = [(_conflict(fit), slip.name) for slip in slips_of(stances) if (fit := fit_payload(slip.undo(stances))).upright]
    ranked = sorted((found for found in tried if found[0] < before / MOTION_TIMES_BETTER), key=lambda found: found[0])
    leading = [name for conflict, name in ranked if conflict < ALIKE * max(ranked[0][0], 1.0)][:MOST_NAMED]
    return SetupExplanation(tuple(leading), before / max(ranked[0][0], 1.0)) if leading else None


def _conflict(fit: PayloadFit) -> float:
    """Misfit of the stances together with how little weight and inertia agree."""
    return float(np.sqrt(fit.misfit**2 + measure_disagreement(fit) / DISAGREEMENT))


def _times(stated: PayloadFit, other: PayloadFit) -> float:
    return stated.misfit / max(other.misfit, 1.0)


def _is_possible(fit: PayloadFit) -> bool:
    return (fit.upright or fit.upside_down) and fit.lever_m < LONGEST_LEVER_M


def _name(slip: Message, fit: PayloadFit) -> Message:
    return Message.of("setup-both", first=slip, second=Message.of("setup-wrench-sign")) if fit.upside_down else slip


def _explain_sign(stances: Stances, stated: PayloadFit) -> SetupExplanation:
    """A negative mass: the wrench or gravity has the other sign; only motion tells them apart."""
    up = Message.of("setup-gravity-along", gravity_m_s2=(-stances.gravity).round(3).tolist())
    return SetupExplanation((Message.of("setup-wrench-sign"), up), abs(stated.mass) / stated.mass_std)
