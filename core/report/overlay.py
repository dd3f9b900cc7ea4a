"""What the diagnosis report draws of the wrench, taken from the evidence."""

from __future__ import annotations

from core.gap.evidence import Evidence
from core.gap.windows import OFFSET
from core.report.diagnosis_page import Overlay


def overlay_of(evidence: Evidence) -> Overlay:
    """Measured, and simulated without and with the effect, offsets taken off."""
    windows, best = evidence.windows, evidence.best
    measured = windows.y - best.beta[OFFSET]
    return Overlay(
        t=windows.centres,
        phase=windows.phase,
        measured=measured,
        before=measured - windows.unwhiten(evidence.nominal.residual),
        after=measured - windows.unwhiten(best.residual),
        noise_std=windows.noise_std,
    )
