"""From a diagnosis to an entry of the cell's twin."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from core.cell.cell import Cell
from core.effects.effect import Effect
from core.effects.library import library, symptoms
from core.errors import BadTwin
from core.gap.addable import Objection, check_addable, check_closure, check_shown, split_parameter_rows
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
from core.words.message import Message

ASKED = Message.of("gap-effect-asked")
MOST_LETTERS = 80
"""Of a name that is not known."""


def with_effect(twin: Twin, cell: Cell, folder: Path, identifier: str, *, fit_all: FitAll = on_all_cores) -> Twin:
    """The cell's twin with an effect as a recording shows it.

    Args:
        twin: of the cell; the diagnosis starts from it, so an effect that it has already is fitted anew.
        folder: of the recording, which is only read.
        identifier: of the effect, or of two joined by a plus sign, which are fitted together.

    Raises:
        BadTwin: no such effect, or the recording does not show it; its message says why.
        BadRecording: the recording cannot be read, or is of another cell.
    """
    chosen = find_effects(identifier)
    recording = read_recording(folder)
    where, objection = _object_to_cell(recording, cell, folder)
    if objection is not None:
        raise objection.at(where)
    diagnosis, evidence = examine(recording, None if len(chosen) == 1 else chosen, twin, fit_all=fit_all)
    if evidence is None:
        raise BadTwin(f"{folder}", "gap-says-nothing", reason=diagnosis.lacking or diagnosis.summary)
    fit = _fit_of(evidence, chosen, str(folder))
    check_addable(evidence, fit, str(folder))
    source = {"recording": folder.resolve().name, "sha256": recording_sha256(folder), "added": datetime.now(UTC)}
    for entry in _entries(evidence, fit, source):
        twin = twin.with_entry(entry)
    return twin


def addable_to(diagnosis: Diagnosis, cell: Cell, recording: Recording, folder: Path) -> Diagnosis:
    """The diagnosis as far as that cell's twin is concerned, which takes nothing from a recording of another cell."""
    _, objection = _object_to_cell(recording, cell, folder)
    if objection is not None:
        against = {"addable": False, "why_not": objection.against}
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
            raise BadTwin(ASKED, "gap-not-on-wrench", name=name, title=read_off[name].title)
        if name not in known:
            raise BadTwin(ASKED, "gap-no-such-effect", name=name[:MOST_LETTERS], wanted=close_name(name, sorted(known)))
    if len(names) > 2:
        raise BadTwin(ASKED, "gap-too-many-effects", count=len(names))
    return tuple(known[name] for name in names)


def _object_to_cell(recording: Recording, cell: Cell, folder: Path) -> tuple[str, Objection | None]:
    """What stands against a recording as one of this cell, and where."""
    if recording.cell is not None and recording.cell != cell.name:
        against = Message.of("gap-other-cell", found=recording.cell)
        return f"{folder}: cell", Objection(against, Message.of("gap-wanted-cell", cell=cell.name))
    joints, expected = 0 if recording.q is None else recording.q.shape[1], len(cell.robot.home_rad)
    if joints not in (0, expected):
        against = Message.of("gap-other-joints", joints=joints)
        return f"{folder}", Objection(against, Message.of("gap-wanted-joints", joints=expected, cell=cell.name))
    return f"{folder}", None


def _fit_of(evidence: Evidence, chosen: tuple[Effect, ...], where: str) -> EffectFit:
    """The fit of these effects together."""
    check_shown(evidence, chosen, where)
    ids = {effect.id for effect in chosen}
    for fit in (*evidence.singles, *evidence.pairs):
        if {effect.id for effect in fit.effects} == ids:
            return fit
    best = min(evidence.singles, key=lambda fit: float(fit.held_out.sum()))
    check_closure(evidence, best, where)
    raise BadTwin(where, "gap-one-is-enough", best=best.name)


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
