"""Effects that do not change the predicted wrench, read off the recording directly."""

from __future__ import annotations

import numpy as np

from core.effects.effect import View
from core.effects.library import symptoms
from core.gap.answer import Minor, Value
from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows
from core.recording import Recording

SEEN_SIGMA = 5.0


def observed(recording: Recording, windows: Windows, fit: EffectFit) -> list[Minor]:
    """Symptoms that stand clearly above chance."""
    holds = tuple(part.rows for part in windows.basis.segments if part.is_hold)
    view = View(holds, windows.basis.noise.std, fit.phi, fit.phi_std)
    found = []
    for symptom in symptoms():
        finding = symptom.observe(recording, view)
        if finding is None or finding.sigma < SEEN_SIGMA:
            continue
        values = {
            p.name: Value(value=float(v), std=float(s) if np.isfinite(s) else None, unit=p.unit)
            for p, v, s in zip(symptom.parameters(recording), finding.theta, finding.std, strict=True)
        }
        found.append(Minor(id=symptom.id, parameters=values, sentence=finding.sentence))
    return found
