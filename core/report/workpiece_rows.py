"""The workpiece alone as words of the report."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.estimation.estimate import Identification
from core.payload.inertia import PHI_UNITS
from core.recording.recording import Recording
from core.recording.workpiece import Workpiece, workpiece_alone
from core.report.rows import INTERVAL, LABELS, error_of, round_to_uncertainty, sentence, two_digits
from core.words.wording import Wording


@dataclass(frozen=True)
class WorkpieceRow:
    """One of the ten parameters; empty where there is nothing to say."""

    name: str
    unit: str
    reference: str
    value: str
    interval: str
    error: str
    known: bool
    outside: bool


@dataclass(frozen=True)
class WorkpieceBlock:
    """What the page says of the workpiece.

    Args:
        tools: in words, with their masses.
    """

    tools: str
    rows: list[WorkpieceRow]
    has_reference: bool
    reference_source: str | None
    remarks: list[str]


def workpiece_block(identification: Identification, recording: Recording, words: Wording) -> WorkpieceBlock | None:
    """The workpiece without the tools; None where there are no tools or nothing was identified."""
    if identification.estimate is None or not recording.tools:
        return None
    found = workpiece_alone(identification.estimate, recording.tools)
    reference = np.full(10, np.nan) if recording.reference is None else recording.reference.phi
    return WorkpieceBlock(
        tools=f" {words.say('report-and')} ".join(
            words.say("report-tool", title=tool.title, mass_kg=float(tool.parameters.mass)) for tool in recording.tools
        ),
        rows=[_row(found, float(reference[k]), k, words) for k in range(10)],
        has_reference=recording.reference is not None,
        reference_source=recording.reference_source,
        remarks=[sentence(remark, words) for remark in found.remarks],
    )


def _row(found: Workpiece, truth: float, k: int, words: Wording) -> WorkpieceRow:
    value, half = float(found.phi[k]), INTERVAL * float(found.std[k])
    known = bool(np.isfinite(value))
    return WorkpieceRow(
        name=LABELS[k],
        unit=PHI_UNITS[k].replace("m2", "m²"),
        reference=words.mark(round_to_uncertainty(truth)),
        value=words.mark(round_to_uncertainty(value, half)) if known else words.say("report-not-determined"),
        interval=words.mark(two_digits(half)) if known else "",
        error=words.mark(error_of(value, truth)),
        known=known,
        outside=known and bool(abs(value - truth) > half),
    )
