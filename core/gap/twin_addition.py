"""What a recording shows goes into the cell's twin, by a diagnosis of its own."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import TypeVar

from core.cell.cell import Cell
from core.effects.effect import Effect
from core.effects.library import library, symptoms
from core.errors import BadTwin
from core.gap.addable import check_addable, check_closure, check_shown
from core.gap.addition import ASKED, make_entries, object_to_cell
from core.gap.answer import Diagnosis, Explanation, Origin, Pair
from core.gap.answering import explain, explain_both
from core.gap.closure import gap_of
from core.gap.diagnosis import examine, find_origin
from core.gap.evidence import MOST_TOGETHER, Evidence
from core.recording.folder import read_recording
from core.recording.stated_friction import with_cell_friction
from core.twin.file import check_twin, close_name
from core.twin.twin import Twin

Found = TypeVar("Found", Explanation, Pair)

MOST_LETTERS = 80
"""Of a name that is not known."""


def with_effect(twin: Twin, cell: Cell, folder: Path, identifier: str) -> Twin:
    """The cell's twin with an effect as a recording shows it, be it material or not.

    Args:
        twin: of the cell; the diagnosis starts from it, so an effect that it has already is fitted anew.
        folder: of the recording, which is only read.
        identifier: of the effect, or of two joined by a plus sign, which are fitted together.

    Raises:
        BadTwin: no such effect, or the recording does not show it; its message says why.
        BadRecording: the recording cannot be read, or is of another cell.
    """
    chosen = find_effects(identifier)
    recording = with_cell_friction(read_recording(folder), cell)
    origin = find_origin(recording, folder, twin)
    if objection := object_to_cell(origin, cell):
        raise objection.at(str(folder))
    diagnosis, evidence = examine(recording, None if len(chosen) == 1 else chosen, twin)
    if evidence is None:
        raise BadTwin(str(folder), "gap-says-nothing", reason=diagnosis.lacking or diagnosis.summary)
    found = _find_fitted(evidence, chosen, str(folder))
    gap_before = gap_of(evidence.windows, evidence.nominal)
    return twin.with_found(list(make_entries(found, gap_before, origin, datetime.now(UTC))), origin.twin)


def addable_to(diagnosis: Diagnosis, cell: Cell) -> Diagnosis:
    """The diagnosis as far as that cell's twin is concerned: it takes nothing from a recording of another cell, and nothing that could not
    be read again."""
    origin, gap = diagnosis.origin, diagnosis.gap
    if origin is None or gap is None:
        return diagnosis
    judged = {
        "effects": [_judge(each, gap.before, origin, cell) for each in diagnosis.effects],
        "pairs": [_judge(each, gap.before, origin, cell) for each in diagnosis.pairs],
    }
    return diagnosis.model_copy(update=judged)


def _judge(found: Found, gap_before: float, origin: Origin, cell: Cell) -> Found:
    against = None
    if elsewhere := object_to_cell(origin, cell):
        against = elsewhere.against
    elif found.addable:
        try:
            check_twin(Twin(effects=tuple(make_entries(found, gap_before, origin, datetime.now(UTC)))), cell)
        except BadTwin as error:
            against = error.message
    return found if against is None else found.model_copy(update={"addable": False, "why_not": against})


def find_effects(identifier: str) -> tuple[Effect, ...]:
    """One effect of the library, or two or three.

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
    if len(names) > MOST_TOGETHER:
        raise BadTwin(ASKED, "gap-too-many-effects", count=len(names))
    return tuple(known[name] for name in names)


def _find_fitted(evidence: Evidence, chosen: tuple[Effect, ...], where: str) -> Explanation | Pair:
    """These effects as they were fitted together.

    Raises:
        BadTwin: a twin does not take them as the recording shows them.
    """
    check_shown(evidence, chosen, where)
    ids = {effect.id for effect in chosen}
    for fit, probability in evidence.attribution.explained:
        if {effect.id for effect in fit.effects} == ids:
            check_shown(evidence, fit.effects, where)  # in the shape that was found
            check_addable(evidence, fit, where)
            return explain(evidence, fit, probability) if len(chosen) == 1 else explain_both(evidence, fit, probability)
    best = min(evidence.singles, key=lambda fit: fit.chi_square)
    check_closure(evidence, best, where)
    raise BadTwin(where, "gap-one-is-enough", best=best.name)
