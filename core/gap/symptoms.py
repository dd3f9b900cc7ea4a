"""Effects that do not change the predicted wrench, read off the recording directly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.effects.effect import Finding, Symptom, View
from core.effects.library import symptoms
from core.gap.answer import Value
from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows
from core.recording import Recording

SEEN_SIGMA = 5.0


@dataclass(frozen=True)
class Observed:
    """A symptom with what it found."""

    symptom: Symptom
    finding: Finding
    parameters: dict[str, Value]


def observed(recording: Recording, windows: Windows, nominal: EffectFit, fit: EffectFit) -> list[Observed]:
    """Symptoms that stand clearly above chance, the clearest first.

    Args:
        nominal, fit: without and with what explains the wrench best; what that changes in the payload counts as its uncertainty.
    """
    holds = tuple(part.rows for part in windows.basis.segments if part.is_hold)
    view = View(holds, windows.basis.noise.std, fit.phi, np.hypot(fit.phi_std, fit.phi - nominal.phi))
    found = []
    for symptom in symptoms():
        finding = symptom.observe(recording, view)
        if finding is None or finding.sigma < SEEN_SIGMA:
            continue
        values = {
            p.name: Value(value=float(v), std=float(s) if np.isfinite(s) else None, unit=p.unit)
            for p, v, s in zip(symptom.parameters(recording), finding.theta, finding.std, strict=True)
        }
        found.append(Observed(symptom, finding, values))
    behind = {name for seen in found for name in seen.symptom.explains}
    return sorted((seen for seen in found if seen.symptom.id not in behind), key=lambda seen: -seen.finding.sigma)
