"""The diagnosis of a recording's folder; the only file here that knows what is tried."""

from __future__ import annotations

import time
from pathlib import Path

from threadpoolctl import threadpool_limits

from bench.stranger.answer import Answer, Weighed
from core.gap.answer import Diagnosis
from core.gap.diagnosis import examine
from core.gap.effect_fit import EffectFit
from core.gap.fit_all import one_by_one
from core.recording.folder import read_recording
from core.recording.recording import Recording

FIRST_EFFECTS, FIRST_PAIRS = 6, 4
"""So many are kept."""


def diagnose(folder: Path) -> Answer:
    """On one core."""
    began = time.process_time()
    recording = read_recording(folder)
    with threadpool_limits(1):
        found, evidence = examine(recording, fit_all=one_by_one)
    return Answer(
        case=folder.name,
        verdict=found.verdict,
        summary=str(found.summary)[:300],
        gap=None if found.gap is None else (found.gap.before, found.gap.after),
        none=found.none_probability,
        unknown=found.unknown_probability,
        effects=tuple((each.id, each.probability, each.closure) for each in found.effects[:FIRST_EFFECTS]),
        pairs=tuple((each.ids, each.probability, each.closure) for each in found.pairs[:FIRST_PAIRS]),
        also=tuple((each.id, each.material) for each in found.also),
        minor=tuple(each.id for each in found.minor),
        tied=tuple(each.ids for each in found.indistinguishable),
        weighed=() if evidence is None else tuple(map(_weigh, (evidence.nominal, *evidence.singles, *evidence.joined))),
        payload_off=_find_off(recording, found),
        cpu=round(time.process_time() - began, 1),
    )


def _weigh(fit: EffectFit) -> Weighed:
    return Weighed(name=fit.name, effects=len(fit.effects), free=fit.free, rows=fit.held_out.size, chi_square=fit.chi_square)


def _find_off(recording: Recording, found: Diagnosis) -> tuple[float, ...]:
    if found.payload is None or recording.reference is None:
        return ()
    after = found.payload.after
    rows = zip(after.phi, recording.reference.phi, after.std, after.determined, strict=True)
    return tuple((phi - reference) / std for phi, reference, std, is_determined in rows if is_determined and std > 0.0)
