"""What was fitted to one recording, and what it comes to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.effects.effect import Effect
from core.gap.answer import Verdict
from core.gap.attribution import Attribution, attribute, choose_variants, probabilities
from core.gap.closure import gap_of
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import FitAll, Task, on_all_cores
from core.gap.limits import GAP
from core.gap.materiality import find_margins, is_hidden
from core.gap.partners import leave_out_each, partners, take_fewer
from core.gap.proposal import Proposal
from core.gap.singles import Singles, fit_shapes, fit_singly, hold_again, start_beside
from core.gap.sound_gears import ONE_IS_ENOUGH, find_better_gears, find_gears_among
from core.gap.tie import Tie, distance_sigma
from core.gap.weighing import find_left_share, find_mattering, is_in_doubt, read_figures
from core.gap.windows import Windows
from core.words.message import Message

EXPLAINED = 0.5
"""Probability from which one name is given."""
MATTERS = 1.0 / 3.0
"""Probability from which something is said to matter: what is named in vain costs a look, what is not named a wrong payload."""
FIRSTS, FURTHER, RIVALS = 2, 3, 2
"""A second effect is sought for the best two single ones, a third for the best pair; the three most promising ones of each are fitted. What
stands for several at once bends best alone, and is left out again: so then is each of the best set, and others are sought in its place;
where that leaves little, of its rival, too."""
MOST_TOGETHER, EXCHANGES = 3, 3
EQUATIONS = 5
"""For each parameter of several effects at once, at least: a list of poses has few, and much would fit it."""
MUCH = 0.05
"""Share of the excess left over from which something is sought that could take up whatever is slow; with less the best set is compared
with a rival that was sought as thoroughly."""
FURTHER_EXPLAINS = 1.0 / 3.0
"""A further effect has to explain most of what those before it leave over, or it is none."""


@dataclass(frozen=True)
class Evidence:
    """Everything that was fitted to one recording.

    Args:
        windows: of the recording, with what the twin always has on.
        nominal: the twin as it is.
        singles, joined: one effect added, or two or three at once.
        attribution: their probabilities.
        limits: which effects the recording cannot show, and why.
        proposals: what to measure next, best first.
    """

    windows: Windows
    nominal: EffectFit
    singles: tuple[EffectFit, ...]
    joined: tuple[EffectFit, ...]
    attribution: Attribution
    limits: tuple[Message, ...]
    proposals: tuple[Proposal, ...] = ()

    @property
    def best(self) -> EffectFit:
        """The most probable explanation, the nominal twin where nothing is more probable than any."""
        explained = self.attribution.explained
        return explained[0][0] if explained and self.attribution.none < EXPLAINED else self.nominal

    @property
    def named(self) -> EffectFit:
        """The most probable explanation where the verdict gives a name, else the nominal twin."""
        return self.best if self.verdict in ("explained", "ambiguous") else self.nominal

    @cached_property
    def mattering(self) -> float:
        """Probability that what is there matters, if anything is."""
        margins = find_margins(self.windows, self.nominal, self.best)
        return float(find_mattering(np.array(margins), read_figures().matters, self.attribution.unknown))

    @property
    def none(self) -> float:
        """Probability that there is nothing, or nothing that matters."""
        return 1.0 - self.mattering * (1.0 - self.attribution.none)

    @property
    def material(self) -> bool:
        """Whether something is said to matter."""
        return self.none < 1.0 - MATTERS

    @property
    def verdict(self) -> Verdict:
        """What the wrench comes to."""
        attribution = self.attribution
        if not self.material:
            return "no_gap"
        if not attribution.explained or attribution.unknown >= attribution.explained[0][1]:
            return "unknown"
        if attribution.ties or attribution.explained[0][1] < EXPLAINED:
            return "ambiguous"
        return "explained"

    @cached_property
    def in_doubt(self) -> bool:
        """Whether so much is left that one looks for what no effect of the library can explain: contacts, single motions that went
        otherwise."""
        return self.material and is_in_doubt(self.nominal, *self.singles, *self.joined)

    @property
    def rivals(self) -> tuple[Tie, ...]:
        """What is to be told apart next: the ties, or the two most probable explanations of as many effects where none is tied."""
        explained = [fit for fit, _ in self.attribution.explained]
        alike = [fit for fit in explained if len(fit.effects) == len(explained[0].effects)]
        if self.attribution.ties or len(alike) < 2:
            return self.attribution.ties
        first, second = alike[:2]
        return (Tie(first, second, distance_sigma(self.windows, first, second)),)


def gather(windows: Windows, effects: Sequence[Effect], fit_all: FitAll = on_all_cores) -> Evidence:
    """Fits all effects singly, and the most promising of them together."""
    return join(fit_singly(windows, effects, fit_all), fit_all)


def join(found: Singles, fit_all: FitAll = on_all_cores) -> Evidence:
    """Two or three effects at once where one leaves something to explain that may matter, and what all of it comes to."""
    windows, nominal, singles = found.windows, found.nominal, list(found.fits)
    if is_hidden(windows, nominal):
        return Evidence(windows, nominal, tuple(singles), (), attribute(windows, nominal, singles), found.limits)
    joinable = [effect for effect in (*found.shown, *found.wider) if not effect.stands_alone]
    grown = _join(windows, nominal, singles, joinable, fit_all)
    if min((find_left_share(nominal, fit) for fit in (*singles, *grown)), default=0.0) > MUCH:
        singles, grown = _resort_to(windows, nominal, list(found.last), singles, grown, fit_all)
    needed = [] if found.stated else _find_needed(nominal, singles, grown)
    among = next((find_gears_among(windows, fit, fit_all) for fit in needed[:1]), None)
    among = among or find_better_gears(windows, nominal, _take_most_probable(nominal, needed), fit_all)
    if among is not None:
        found = hold_again(found, among, fit_all)
        windows, nominal, singles = found.windows, found.nominal, list(found.fits)
        grown = _join(windows, nominal, singles, joinable, fit_all)
    fewer = fit_all(windows, [task for fit in grown[:1] for task in take_fewer(windows, fit)])
    singles = choose_variants(nominal, [*singles, *(fit for fit in fewer if not fit.further)])
    joined = _find_needed(nominal, singles, _take_most_first(nominal, [*grown, *(fit for fit in fewer if fit.further)]))
    attribution = attribute(windows, nominal, [*singles, *joined])
    return Evidence(windows, nominal, tuple(singles), tuple(joined), attribution, found.limits)


def _join(windows: Windows, nominal: EffectFit, singles: list[EffectFit], effects: list[Effect], fit_all: FitAll) -> list[EffectFit]:
    """Two effects at once, where one leaves something to explain, and where two do, three; each set once, in the shapes that are most
    probable, those of most effects first, and of as many the best."""
    best = sorted(singles, key=lambda fit: fit.chi_square)
    if not best or not _leaves_more(windows, nominal, best[0]) or probabilities(nominal, singles)[0] > EXPLAINED:
        return []
    joinable = _take_joinable(best)
    firsts = joinable[:FIRSTS]
    if not firsts:
        return []
    fitted = {key: fit for fit in joinable for key in _keys_of(fit)}
    found: list[EffectFit] = []
    while _leaves_more(windows, nominal, firsts[0]) and len(firsts[0].effects) < MOST_TOGETHER:
        seen, grown = {key for first in firsts for key in _keys_of(first)}, _fit_with_partners(windows, nominal, firsts, effects, fit_all)
        for _ in range(EXCHANGES):
            little = bool(grown) and find_left_share(nominal, grown[0]) < MUCH
            each = (rest for fit in grown[: RIVALS if little else 1] for rest in leave_out_each(windows, fit))
            rests = {key: rest for rest in each if (key := _name_shapes(rest) if little else rest.name) not in seen}
            if not rests:
                break
            seen |= {key for rest in rests.values() for key in _keys_of(rest)}
            new = fit_all(windows, [rest for key, rest in rests.items() if key not in fitted])
            fitted |= {key: fit for fit in new for key in _keys_of(fit)}
            further = _fit_with_partners(windows, nominal, [fitted[key] for key in rests], effects, fit_all)
            grown = _take_each_once(nominal, [*grown, *further])
        if not grown:
            break
        richer = [task for task in start_beside(windows, nominal, grown, effects) if task.thetas]
        grown = _take_each_once(nominal, [*grown, *fit_all(windows, richer)]) if richer else grown
        firsts, found = grown[:1], [*grown, *found]
    rests_of_three = [fit for fit in fitted.values() if len(fit.effects) > 1]
    return _take_most_first(nominal, [*found, *rests_of_three])


def _keys_of(of: EffectFit | Task) -> tuple[str, str]:
    """What a set of effects is found again by: where much is left any of its shapes will do, where little is only these."""
    return of.name, _name_shapes(of)


def _name_shapes(of: EffectFit | Task) -> str:
    return "+".join(f"{effect.id} as {type(effect).__name__}" for effect in of.effects)


def _resort_to(
    windows: Windows, nominal: EffectFit, last: list[Effect], singles: list[EffectFit], grown: list[EffectFit], fit_all: FitAll
) -> tuple[list[EffectFit], list[EffectFit]]:
    """Single effects and sets with what is sought last, by itself and beside the best single ones."""
    scene, residual = windows.basis.scene.with_phi(nominal.phi), windows.on_grid(nominal.residual)
    tasks = [Task((effect,), nominal, effect.starts(scene, residual)) for effect in last]
    firsts = sorted(_take_joinable(singles), key=lambda fit: fit.chi_square)[:FIRSTS]
    beside = _fit_with_partners(windows, nominal, firsts, last, fit_all)
    singles = choose_variants(nominal, [*singles, *fit_all(windows, [task for task in tasks if task.thetas])])
    return singles, _take_most_first(nominal, [*grown, *beside])


def _leaves_more(windows: Windows, nominal: EffectFit, fit: EffectFit) -> bool:
    """Whether there may be a further effect: what is left is no small share of the gap, or matters by itself."""
    return find_left_share(nominal, fit) >= ONE_IS_ENOUGH or gap_of(windows, fit) > GAP


def _take_joinable(singles: list[EffectFit]) -> list[EffectFit]:
    """Those that are sought beside others, too."""
    return [fit for fit in singles if not fit.effects[0].stands_alone]


def _find_needed(nominal: EffectFit, singles: list[EffectFit], joined: list[EffectFit]) -> list[EffectFit]:
    """Of several effects at once, those sets whose further effects each explain most of what fewer leave."""
    least = min((find_left_share(nominal, fit) for fit in _take_joinable(singles)), default=1.0)
    few = (fit for fit in joined if EQUATIONS * fit.free < fit.rows)
    return [fit for fit in few if find_left_share(nominal, fit) < FURTHER_EXPLAINS**fit.further * least]


def _take_most_probable(nominal: EffectFit, fits: list[EffectFit]) -> list[EffectFit]:
    """The most probable ones, the first before the second."""
    *_, shares = probabilities(nominal, fits)
    return [fits[k] for k in np.argsort(shares)[::-1][:RIVALS]]


def _fit_with_partners(
    windows: Windows, nominal: EffectFit, firsts: list[EffectFit], effects: list[Effect], fit_all: FitAll
) -> list[EffectFit]:
    """Each with one effect more, all in their smaller shapes, too, the best first."""
    return _take_each_once(nominal, fit_shapes(windows, partners(windows, firsts, effects, FURTHER, fit_all), fit_all))


def _take_most_first(nominal: EffectFit, fits: list[EffectFit]) -> list[EffectFit]:
    """Each set of effects once, those of most effects first, and of as many the best."""
    return sorted(_take_each_once(nominal, fits), key=lambda fit: -len(fit.effects))


def _take_each_once(nominal: EffectFit, fits: list[EffectFit]) -> list[EffectFit]:
    """Each set of effects in the shapes that are most probable, the best first: of what is left, the smaller one (Schwarz's criterion)."""
    return sorted(choose_variants(nominal, fits), key=lambda fit: fit.chi_square + fit.free * float(np.log(fit.rows)))
