"""Which further effect would explain most of what others leave over: a linear look at every effect before both are fitted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.effect import STAGES, Effect
from core.estimation.quadratic import find_bounded_minimum
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import FitAll, Task
from core.gap.problem import Problem, parameters_of
from core.gap.windows import Windows

AS_MUCH = 0.5
"""Share of what the best shape of an effect would explain from which another one of its shapes is fitted as well."""


PARTS = 8
"""In which the effects are looked at: enough for all cores, few enough that what a fit needs itself is not found too often."""


class Partner(NamedTuple):
    """A further effect: how much it would explain, and with which values."""

    gain: float
    effect: Effect
    theta: Array


class Look(NamedTuple):
    """At some effects beside a fit."""

    first: EffectFit
    effects: tuple[Effect, ...]

    @property
    def size(self) -> int:
        """About how many derivatives it takes."""
        return len(self.effects) + len(self.first.theta)

    def run(self, windows: Windows) -> list[Partner]:
        """Each effect from each of its starts, where it explains more than its parameters may bend."""
        first = self.first
        known = Problem(windows, first.effects)
        J = known.linearise(first.theta, first.phi)[1]
        X = known.columns(first.theta, first.phi)
        columns, normal = np.column_stack((X, J)), known.normal(X, J)
        scene = windows.basis.scene.with_phi(first.phi)
        residual = windows.on_grid(first.residual)
        held = Problem(windows, ()).linearise(np.zeros(0), first.phi)[0]  # by what the twin has, which the first's residual is without
        found = (
            _join(known, first, columns, normal, Problem(windows, (effect,)), theta, held)
            for effect in self.effects
            for theta in effect.starts(scene, residual)
        )
        return [partner for partner in found if partner.gain > 0.0]


def partners(windows: Windows, firsts: Sequence[EffectFit], effects: Sequence[Effect], count: int, fit_all: FitAll) -> list[Task]:
    """The most promising additions to each of some fits, with the values to start from.

    Args:
        firsts: the fits, each of one effect or more.
        effects: candidates for a further one, in all their shapes; those of the fit are passed over.
        count: how many effects are added to each; none that explains less than its parameters may bend.
    """
    others = [[effect for effect in effects if effect.id not in {each.id for each in first.effects}] for first in firsts]
    looks = [Look(first, tuple(some[k::PARTS])) for first, some in zip(firsts, others, strict=True) for k in range(PARTS)]
    found = fit_all(windows, looks)
    each = (chain.from_iterable(found[k : k + PARTS]) for k in range(0, len(found), PARTS))
    return [task for first, some in zip(firsts, each, strict=True) for task in _choose(windows, first, some, count)]


def _choose(windows: Windows, first: EffectFit, found: Iterable[Partner], count: int) -> list[Task]:
    best: dict[str, list[Partner]] = {}
    for partner in sorted(found, key=lambda partner: -partner.gain):
        shapes = best.setdefault(partner.effect.id, [partner])
        if partner.gain >= AS_MUCH * shapes[0].gain and all(type(partner.effect) is not type(shape.effect) for shape in shapes):
            shapes.append(partner)
    chosen = [partner for shapes in list(best.values())[:count] for partner in shapes]
    return [add_effect(windows, first, partner.effect, [partner.theta]) for partner in chosen]


def add_effect(windows: Windows, fit: EffectFit, effect: Effect, thetas: list[Array]) -> Task:
    """The effects of a fit, none or more, with one more that starts from each of some values."""
    terms = terms_of(windows, fit)
    order = sorted([*terms, (effect, thetas[0])], key=lambda term: (STAGES.index(term[0].stage), term[0].id))
    starts = [np.concatenate([theta if each is effect else known for each, known in order]) for theta in thetas]
    return Task(tuple(each for each, _ in order), fit, starts)


def leave_out_each(windows: Windows, fit: EffectFit) -> list[Task]:
    """The effects of a fit without one of them, for each."""
    terms = terms_of(windows, fit)
    return [_task_of(fit, [*terms[:k], *terms[k + 1 :]]) for k in range(len(terms))]


def take_fewer(windows: Windows, fit: EffectFit) -> list[Task]:
    """Each effect of a fit by itself, and where it has more than two each set without one, from the values that they have among the others:
    where they began without these they may have ended elsewhere."""
    alone = [_task_of(fit, [term]) for term in terms_of(windows, fit)]
    return [*alone, *leave_out_each(windows, fit)] if len(alone) > 2 else alone


def _join(known: Problem, first: EffectFit, columns: Array, normal: Array, joining: Problem, theta: Array, held: Array) -> Partner:
    """Fall of chi-square when an effect joins, linearised at theta, less what its parameters may bend. All stays within its bounds: freed
    of them, small imperfections could stand for most effects.

    Args:
        held: (6K,), rows of the change without it.
    """
    theta = np.clip(theta, joining.lower, joining.upper)
    rows, J = joining.linearise(theta, first.phi)
    of_effect = joining.precision[-len(theta) :]
    precision = np.concatenate((known.precision, of_effect))
    here = np.concatenate((first.beta, first.theta, theta))
    mean = np.concatenate((np.zeros(len(first.beta)), known.absent, joining.absent))
    bounds = np.column_stack((known.bounds, (joining.lower, joining.upper))) - here
    before = first.residual.ravel()
    r = before - (rows - held)
    across = columns.T @ J
    whole = np.block([[normal, across], [across.T, J.T @ J + np.diag(of_effect)]])
    step = find_bounded_minimum(whole, np.concatenate((columns.T @ r, J.T @ r)) + precision * (mean - here), bounds)
    after = r - columns @ step[: -len(theta)] - J @ step[-len(theta) :]
    gain = float(before @ before - after @ after) - len(theta) * float(np.log(len(r)))
    return Partner(gain, joining.effects[0], theta + step[-len(theta) :])


def terms_of(windows: Windows, fit: EffectFit) -> list[tuple[Effect, Array]]:
    """Each effect with its parameters; none of a fit without effects."""
    if not fit.effects:
        return []
    ends = np.cumsum([len(parameters_of(windows, effect)) for effect in fit.effects])
    return list(zip(fit.effects, np.split(fit.theta, ends[:-1]), strict=True))


def _task_of(start: EffectFit, terms: list[tuple[Effect, Array]]) -> Task:
    return Task(tuple(effect for effect, _ in terms), start, [np.concatenate([theta for _, theta in terms])])
