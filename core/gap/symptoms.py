"""What stands beside the verdict: effects that do not change the predicted wrench, read off the recording directly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.array import Array
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.library import symptoms
from core.effects.sides import Side
from core.gap.answer import Also, Value
from core.gap.effect_fit import EffectFit
from core.gap.fine_windows import refine
from core.gap.materiality import is_doubtful
from core.gap.problem import Problem
from core.gap.windows import Windows
from core.recording.recording import Recording
from core.words.message import Message

SEEN_SIGMA = 5.0
LEADING: tuple[Side, ...] = ("reference", "reading")
"""What the summary goes on with where it is material, in this order."""


def observe_symptoms(recording: Recording, windows: Windows, nominal: EffectFit, fit: EffectFit, named: EffectFit) -> list[Also]:
    """Symptoms that stand clearly above chance: the material ones first, the clearest first.

    What comes along with another symptom, or looks like one of the effects that explain the wrench, is not named beside it. An effect
    that does not matter, or that the verdict does not stand for, explains nothing: a model of what swings takes up a part of any vibration.

    Args:
        nominal, fit: without and with what explains the wrench best; what that changes in the payload counts as its uncertainty.
        named: what the verdict stands for, the nominal twin where it names no effect.
    """
    holds = tuple(part.rows for part in windows.basis.segments if part.is_hold)
    t, left, expected = _look_finely(windows, named)
    phi_std = np.hypot(fit.phi_std, fit.phi - nominal.phi)
    view = View(holds, windows.basis.noise.std, fit.phi, phi_std, left, expected, t)
    acting = {effect.id for effect in named.effects}
    found: list[tuple[Symptom, Finding]] = []
    for symptom in symptoms():
        if windows.basis.scene.apart and symptom.side != "reference":
            continue
        finding = symptom.observe(recording, view)
        if finding is None or finding.sigma < SEEN_SIGMA or acting & set(symptom.resembled_by):
            continue
        doubtful = symptom.side == "reference" and finding.material and is_doubtful(windows, fit)
        found.append((symptom, _mark_doubtful(finding) if doubtful else finding))
    own = [each for each in found if not any(_stands_before(other, each) for other in found)]
    return [_also(recording, *seen) for seen in sorted(own, key=lambda seen: (not seen[1].material, -seen[1].sigma))]


def _look_finely(windows: Windows, fit: EffectFit) -> tuple[Array, Array, Array]:
    """Times (K,), what a fit leaves of the wrench (K, 6) and what it expects, N and N m, in finer windows than it was fitted in."""
    basis = windows.basis
    if basis.scene.apart:
        left = windows.unwhiten(fit.residual)
        return windows.centres, left, windows.unwhiten(windows.target) - left
    fine = refine(windows)
    change = fine.rows_of([Problem(fine, fit.effects).change(fit.theta, basis.scene.with_phi(fit.phi))])[..., 0]
    left = fine.unwhiten(fine.target - fine.X @ fit.beta - change)
    return fine.centres, left, fine.y - left


def observe_joints(recording: Recording) -> list[Also]:
    """What the joints show by themselves where there is no wrench, the clearest first."""
    unknown = np.full(10, np.nan)
    view = View((), np.zeros(6), unknown, unknown)
    seen = [(symptom, symptom.observe(recording, view)) for symptom in symptoms() if symptom.side == "joints"]
    found = [(symptom, finding) for symptom, finding in seen if finding is not None and finding.sigma >= SEEN_SIGMA]
    return [_also(recording, *each) for each in sorted(found, key=lambda each: (not each[1].material, -each[1].sigma))]


def find_leading(also: list[Also]) -> list[Message]:
    """What is material about the reference and the readings."""
    return [it.message for side in LEADING for it in also if it.side == side and it.material]


def _stands_before(other: tuple[Symptom, Finding], seen: tuple[Symptom, Finding]) -> bool:
    """Whether what was seen comes along with another symptom: as a rule what does not matter accounts for nothing that does."""
    symptom, finding = other
    return seen[0].id in symptom.explains and (finding.material or not seen[1].material or symptom.explains_when_small)


def _mark_doubtful(finding: Finding) -> Finding:
    """The payload seems to be another one, but so it may because of what is wrong with the wrench."""
    return replace(finding, material=False, message=Message.of("symptom-payload-or-gap", seen=finding.message))


def _also(recording: Recording, symptom: Symptom, finding: Finding) -> Also:
    return Also(
        id=symptom.id,
        title=symptom.title,
        side=symptom.side,
        parameters=_values(symptom.parameters(recording), finding),
        times_expected=finding.times_expected,
        material=finding.material,
        message=finding.message,
        advice=symptom.advice(finding),
    )


def _values(parameters: tuple[Parameter, ...], finding: Finding) -> dict[str, Value]:
    """Those that were determined."""
    return {
        p.name: Value(value=float(value), std=float(std) if np.isfinite(std) else None, unit=p.unit)
        for p, value, std in zip(parameters, finding.theta, finding.std, strict=True)
        if np.isfinite(value)
    }
