"""Sound gears where they show: they are a part of the nominal twin then, like its other small imperfections."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy

from core.array import Array
from core.effects.composition import Term
from core.effects.joint_elasticity import JointElasticity
from core.effects.transmission import Transmission
from core.estimation.gears import SOFTEST_RAD_PER_NM, SoundGears
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import FitAll
from core.gap.partners import add_effect, leave_out_each, terms_of
from core.gap.weighing import find_left_share
from core.gap.windows import Windows
from core.words.message import Message

ONE_IS_ENOUGH = 0.005
"""Share of the excess left over by one effect below which nothing is sought besides, neither gears nor a further effect: it would only pick
up what a model gets wrong."""
EXPLAIN = 0.5
"""They have to explain at least this share of what the best explanation without them leaves,"""
BESIDE = 4
"""Single effects beside which they are sought: beside the cause they explain the rest, though what bends more explains more alone."""
AS_SOFTER = 0.9
"""and among several effects at once this share of what joints of any stiffness explain in their place."""


def find_sound_gears(windows: Windows, nominal: EffectFit, singles: list[EffectFit], fit_all: FitAll) -> Term | None:
    """The gears as they show beside one of the best single effects, or beside none; None where they do not show.

    Whether softer joints would explain the gap better is looked at first: then they are the effect.
    """
    best = min(singles, key=lambda fit: fit.chi_square, default=nominal)
    left, soft = find_left_share(nominal, best), best.name == SoundGears.id
    scene = windows.basis.scene.with_phi(nominal.phi)
    if SoundGears().explain_absence(scene) is not None or scene.apart or (left < ONE_IS_ENOUGH and not soft):
        return None
    others = sorted((fit for fit in singles if fit.name != SoundGears.id), key=lambda fit: fit.chi_square)
    fit = _fit_beside(windows, nominal, [nominal, *others[:BESIDE]], fit_all)
    shaking = [fit for fit in others[BESIDE:] if isinstance(fit.effects[0], Transmission)]  # on their springs such effects do much more
    if shaking and (fit is None or find_left_share(nominal, fit) >= ONE_IS_ENOUGH):
        further = _fit_beside(windows, nominal, shaking, fit_all)
        fit = min((each for each in (fit, further) if each is not None), key=lambda fit: fit.chi_square, default=None)
    return None if fit is None or find_left_share(nominal, fit) > left + ONE_IS_ENOUGH else _term_of(windows, fit)


def find_gears_among(windows: Windows, together: EffectFit, fit_all: FitAll) -> Term | None:
    """The gears in the place of the elastic joints among several effects at once, or of those that are held already and were found beside
    less; None where these are softer, or there are none."""
    gears = SoundGears()
    others = [task for task in leave_out_each(windows, together) if gears.id not in task.name.split("+")]
    if len(others) != 1:
        return None
    (rest,) = fit_all(windows, others)
    starts = gears.starts(windows.basis.scene.with_phi(rest.phi), windows.on_grid(rest.residual))
    (fit,) = fit_all(windows, [add_effect(windows, rest, gears, starts)])
    gain = rest.chi_square - together.chi_square
    if gain <= 0.0 or rest.chi_square - fit.chi_square < AS_SOFTER * gain:
        return None
    return _term_of(windows, fit)


def find_better_gears(windows: Windows, nominal: EffectFit, sets: list[EffectFit], fit_all: FitAll) -> Term | None:
    """Gears that are held and were found beside one effect, as they show beside several at once; None where that explains little of what
    these leave."""
    held = [term.theta for term in windows.held if term.effect.id == SoundGears.id]
    others = [fit for fit in sets if SoundGears.id not in fit.name.split("+") and find_left_share(nominal, fit) >= ONE_IS_ENOUGH]
    fit = _fit_beside(windows, nominal, others, fit_all, held) if held and others else None
    return None if fit is None else _term_of(windows, fit)


def _fit_beside(
    windows: Windows, nominal: EffectFit, bases: list[EffectFit], fit_all: FitAll, known: Sequence[Array] = ()
) -> EffectFit | None:
    """The gears beside that of the fits with which they leave least, from what is known of them, too; None where they explain little of
    what it leaves."""
    gears = SoundGears()
    starts = [*known, *gears.starts(windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual))]
    found = fit_all(windows, [add_effect(windows, base, gears, starts) for base in bases])
    base, fit = min(zip(bases, found, strict=True), key=lambda pair: pair[1].chi_square)
    return None if find_left_share(nominal, fit) > EXPLAIN * find_left_share(nominal, base) else fit


def _term_of(windows: Windows, fit: EffectFit) -> Term | None:
    """None where no joint gives: beside rigid gears the fit has only come further than without."""
    theta = next(theta for effect, theta in terms_of(windows, fit) if isinstance(effect, SoundGears))
    return Term(JointElasticity(), theta) if theta[:-2].any() else None


def hold_gears(windows: Windows, gears: Term) -> Windows:
    """The same windows with gears that are always on, in the place of any before."""
    held = copy(windows)
    held.held = (*(term for term in windows.held if term.effect.id != gears.effect.id), gears)
    return held


def describe_gears(gears: Term) -> Message:
    """What has to be known of an answer that has them in its twin: the softest joint, N m/rad."""
    softest = 1.0 / float(gears.theta[:-2].max())
    return Message.of("gap-sound-gears", softest_nm_per_rad=round(softest, -3), least_nm_per_rad=1.0 / SOFTEST_RAD_PER_NM)
