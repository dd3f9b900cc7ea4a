"""From a diagnosis to an entry of the cell's twin."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.cell.cell import Cell
from core.effects.effect import Effect
from core.effects.library import library, symptoms
from core.errors import BadTwin
from core.gap.addable import check_addable, check_closure, check_shown, split_parameter_rows
from core.gap.answer import Diagnosis
from core.gap.closure import gap_of
from core.gap.diagnosis import examine
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence
from core.gap.fit_all import FitAll, on_all_cores
from core.recording.folder import read_recording, recording_sha256
from core.recording.recording import Recording
from core.twin.file import close_name
from core.twin.twin import Entry, Fitted, Twin

Array = NDArray[np.float64]


def with_effect(twin: Twin, cell: Cell, folder: Path, identifier: str, *, fit_all: FitAll = on_all_cores) -> Twin:
    """The cell's twin with an effect as a recording shows it.

    Args:
        twin: of the cell; the diagnosis starts from it, so an effect that it has already is fitted anew.
        folder: of the recording, which is only read.
        identifier: of the effect, or of two joined by a plus sign, which are fitted together.

    Raises:
        BadTwin: no such effect, or the recording does not show it; the sentence says why.
        BadRecording: the recording cannot be read, or is of another cell.
    """
    chosen = find_effects(identifier)
    recording = read_recording(folder)
    _check_cell(recording, cell, folder)
    diagnosis, evidence = examine(recording, None if len(chosen) == 1 else chosen, twin, fit_all=fit_all)
    if evidence is None:
        why = "" if diagnosis.lacking is None else f" ({diagnosis.lacking.sentence})"
        raise BadTwin(f"{folder}", f"a recording that says nothing about a gap{why}", "one of a whole run")
    fit = _fit_of(evidence, chosen, str(folder))
    check_addable(evidence, fit, str(folder))
    source = {"recording": folder.resolve().name, "sha256": recording_sha256(folder), "added": datetime.now(UTC)}
    for entry in _entries(evidence, fit, source):
        twin = twin.with_entry(entry)
    return twin


def addable_to(diagnosis: Diagnosis, cell: Cell, recording: Recording, folder: Path) -> Diagnosis:
    """The diagnosis as far as that cell's twin is concerned, which takes nothing from a recording of another cell."""
    try:
        _check_cell(recording, cell, folder)
    except BadTwin as reason:
        against = {"addable": False, "why_not": reason.found}
        changed = {part: [each.model_copy(update=against) for each in getattr(diagnosis, part)] for part in ("effects", "pairs")}
        return diagnosis.model_copy(update=changed)
    return diagnosis


def find_effects(identifier: str) -> tuple[Effect, ...]:
    """One effect of the library, or two.

    Raises:
        BadTwin: there is no such effect, or it does not act on the wrench.
    """
    known = {effect.id: effect for effect in library()}
    read_off = {symptom.id: symptom for symptom in symptoms()}
    names = tuple(dict.fromkeys(identifier.split("+")))
    for name in names:
        if name in read_off:
            raise BadTwin("effect", f"{name!r}, {read_off[name].title}, which does not act on the wrench", "an effect that does")
        if name not in known:
            raise BadTwin("effect", repr(name), str(close_name(name, sorted(known))))
    if len(names) > 2:
        raise BadTwin("effect", f"{len(names)} effects at once", "one, or two joined by a plus sign; add the others afterwards")
    return tuple(known[name] for name in names)


def _check_cell(recording: Recording, cell: Cell, folder: Path) -> None:
    if recording.cell not in (None, cell.name):
        raise BadTwin(f"{folder}: cell", f"a recording of the cell {recording.cell!r}", f"{cell.name!r}, whose twin it is to change")
    joints = 0 if recording.q is None else recording.q.shape[1]
    if joints not in (0, len(cell.robot.home_rad)):
        raise BadTwin(f"{folder}", f"a recording of {joints} joints", f"{len(cell.robot.home_rad)}, as in the cell {cell.name!r}")


def _fit_of(evidence: Evidence, chosen: tuple[Effect, ...], where: str) -> EffectFit:
    """The fit of these effects together."""
    check_shown(evidence, chosen, where)
    ids = {effect.id for effect in chosen}
    for fit in (*evidence.singles, *evidence.pairs):
        if {effect.id for effect in fit.effects} == ids:
            return fit
    best = min(evidence.singles, key=lambda fit: float(fit.held_out.sum()))
    check_closure(evidence, best, where)
    raise BadTwin(where, f"no more explained by both than by {best.name} alone", f"{best.name!r}, if that is what was meant")


def _entries(evidence: Evidence, fit: EffectFit, source: dict[str, Any]) -> Iterator[Entry]:
    """One entry for each effect of the fit."""
    windows = evidence.windows
    for effect, rows in split_parameter_rows(evidence, fit):
        values = zip(fit.parameters[rows], fit.theta[rows], fit.theta_std[rows], strict=True)
        covariance = fit.uncertainty[len(fit.beta) :, len(fit.beta) :][rows, rows]
        yield Entry(
            effect=effect.id,
            parameters={p.name: Fitted(value=float(value), std=float(std), unit=p.unit) for p, value, std in values},
            covariance=tuple(tuple(row) for row in (0.5 * (covariance + covariance.T)).tolist()),
            gap_before=gap_of(windows, evidence.nominal),
            gap_after=gap_of(windows, fit),
            **source,
        )
