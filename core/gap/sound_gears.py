"""Gears that give way as little as sound ones do. Every arm has them and nobody wants them named, but a wrist sensor feels the arm swing on
them: where they show, they are a part of the nominal twin, like its other small imperfections."""

from __future__ import annotations

from copy import copy
from dataclasses import replace

import numpy as np

from core.array import Array
from core.effects.composition import Term
from core.effects.effect import Parameter
from core.effects.joint_elasticity import JointElasticity
from core.effects.joint_error import joint_count
from core.effects.scene import Scene
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import FitAll
from core.gap.partners import add_effect, terms_of
from core.gap.weighing import find_left_share
from core.gap.windows import Windows
from core.words.message import Message

SOFTEST_RAD_PER_NM, USUAL_RAD_PER_NM = 5e-5, 2e-5
"""1 / (20 kN m/rad) and 1 / (50 kN m/rad), of a joint: a softer one is an effect and has to be named."""
STARTS_RAD_PER_NM = (1e-5, 2e-5, 4e-5)
SHOWN = 0.01
"""Share of the excess: where one effect leaves no more, nothing swings besides."""
EXPLAIN = 0.5
"""They have to explain at least this share of what the best explanation without them leaves."""


class SoundGears(JointElasticity):
    """Elastic joints within what is sound."""

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """As of `JointElasticity`."""
        *compliances, inertia, damping = super().parameters(scene)
        bounded = (replace(each, upper=SOFTEST_RAD_PER_NM, scale=USUAL_RAD_PER_NM) for each in compliances)
        return (*bounded, replace(inertia, lower=0.5, upper=1.5, scale=0.1), damping)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:  # noqa: ARG002 - as every effect
        """All joints alike, hardly damped."""
        n = joint_count(scene)
        return [np.array([*[compliance] * n, 1.0, 0.1]) for compliance in STARTS_RAD_PER_NM]


def find_sound_gears(windows: Windows, nominal: EffectFit, singles: list[EffectFit], fit_all: FitAll) -> Term | None:
    """The gears as they show beside the best single effect, or beside none; None where they do not show.

    Whether softer joints would explain the gap better is looked at first: then they are the effect.
    """
    gears = SoundGears()
    best = min(singles, key=lambda fit: fit.chi_square, default=nominal)
    left, soft = find_left_share(nominal, best), best.name == gears.id
    scene = windows.basis.scene.with_phi(nominal.phi)
    known = gears.id in {term.effect.id for term in windows.held}
    if known or gears.explain_absence(scene) is not None or scene.apart or (left < SHOWN and not soft):
        return None
    others = [fit for fit in singles if fit.name != gears.id]
    bases = [nominal, *sorted(others, key=lambda fit: fit.chi_square)[:1]]
    starts = gears.starts(scene, windows.on_grid(nominal.residual))
    found = fit_all(windows, [add_effect(windows, base, gears, starts) for base in bases])
    base, fit = min(zip(bases, found, strict=True), key=lambda pair: pair[1].chi_square)
    there = find_left_share(nominal, fit)
    if there > EXPLAIN * find_left_share(nominal, base) or there > left + SHOWN:
        return None
    return Term(JointElasticity(), next(theta for effect, theta in terms_of(windows, fit) if isinstance(effect, SoundGears)))


def hold_gears(windows: Windows, gears: Term) -> Windows:
    """The same windows with gears that are always on."""
    held = copy(windows)
    held.held = (*windows.held, gears)
    return held


def describe_gears(gears: Term) -> Message:
    """What has to be known of an answer that has them in its twin: the softest joint, N m/rad."""
    softest = 1.0 / float(gears.theta[:-2].max())
    return Message.of("gap-sound-gears", softest_nm_per_rad=round(softest, -3), least_nm_per_rad=1.0 / SOFTEST_RAD_PER_NM)
