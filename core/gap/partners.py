"""Which second effect would explain most of what a first one leaves over: a linear look at every effect before pairs are fitted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.effect import STAGES, Effect
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import Task
from core.gap.problem import Problem
from core.gap.quadratic import solve_scaled
from core.gap.windows import Windows

STARTS = 2
"""How many of an effect's starting values are looked at."""


class Partner(NamedTuple):
    """A second effect: how much it would explain, and with which values."""

    gain: float
    effect: Effect
    theta: Array


def partners(windows: Windows, first: EffectFit, effects: Sequence[Effect], count: int) -> list[Task]:
    """The most promising pairs with a fitted effect, each with the values to start from.

    Args:
        first: the fit of a single effect.
        effects: candidates for the second one; the first itself is passed over.
        count: how many pairs.
    """
    problem = Problem(windows, first.effects)
    columns = np.column_stack((problem.X, problem.linearise(first.theta, first.phi)[1]))
    scene = windows.basis.scene.with_phi(first.phi)
    residual = windows.on_grid(first.residual)
    found = [
        _join(windows, first, columns, problem.precision, effect, theta)
        for effect in effects
        if effect.id not in {each.id for each in first.effects}
        for theta in effect.starts(scene, residual)[:STARTS]
    ]
    best: dict[str, Partner] = {}
    for partner in sorted(found, key=lambda partner: -partner.gain):
        best.setdefault(partner.effect.id, partner)
    return [_pair(first, partner) for partner in list(best.values())[:count]]


def _join(windows: Windows, first: EffectFit, columns: Array, precision: Array, effect: Effect, theta: Array) -> Partner:
    """Fall of chi-square when the effect joins, linearised at theta, less what its parameters may bend."""
    problem = Problem(windows, (effect,))
    theta = np.clip(theta, problem.lower, problem.upper)
    rows, J = problem.linearise(theta, first.phi)
    count = columns.shape[1]
    columns = np.column_stack((columns, J))
    precision = np.concatenate((precision, problem.precision[-len(theta) :]))
    before = first.residual.ravel()
    r = before - rows
    pull = np.zeros(len(precision))
    pull[count:] = precision[count:] * (problem.absent - theta)
    step = solve_scaled(columns.T @ columns + np.diag(precision), columns.T @ r + pull)
    after = r - columns @ step
    gain = float(before @ before - after @ after) - len(theta) * float(np.log(len(r)))
    return Partner(gain, effect, np.clip(theta + step[count:], problem.lower, problem.upper))


def _pair(first: EffectFit, partner: Partner) -> Task:
    terms = [(first.effects[0], first.theta), (partner.effect, partner.theta)]
    terms.sort(key=lambda term: STAGES.index(term[0].stage))
    return Task(tuple(effect for effect, _ in terms), first, [np.concatenate([theta for _, theta in terms])])
