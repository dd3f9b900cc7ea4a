"""The kinds of jobs: what each is told, and what of it is written into the audit log."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path

from sqlalchemy.orm import Session

from core.words.catalogue import LANGUAGES, Language
from server.cells.folder import CellFolder
from server.http.schemas import RequestBody
from server.jobs.jobs import JobKind, JobStatus
from server.people import audit
from server.runs.tables import JobRow
from server.settings import Settings

DIAGNOSIS, TRIALS = "diagnosis", "trials"


class DiagnosisOrder(RequestBody):
    """A recording to be diagnosed; that of a run, or an uploaded one.

    Args:
        cell: the one it was made in; `tool`: what the robot carried. Both where they are known.
        name: that somebody gave to an uploaded one.
    """

    recording: Path
    run: str | None = None
    cell: str | None = None
    tool: str | None = None
    name: str | None = None


class TrialsOrder(RequestBody):
    """So many blind trials, from a seed on."""

    count: int
    seed: int


def locate_report(settings: Settings, diagnosis: str, language: Language) -> Path:
    """Where a diagnosis leaves its page in a language."""
    return settings.reports_folder / (f"{diagnosis}.html" if language == "en" else f"{diagnosis}.{language}.html")


def locate_overlay(settings: Settings, diagnosis: str) -> Path:
    """Where a diagnosis leaves what it compared."""
    return settings.reports_folder / f"{diagnosis}.overlay.json"


def diagnoses(settings: Settings, cells: CellFolder) -> JobKind:
    """What parts simulation and recording."""

    def arguments(row: JobRow) -> tuple[object, ...]:
        order = DiagnosisOrder.model_validate_json(row.order)
        cell = None if order.cell is None else cells.load(order.cell)
        reports = {language: locate_report(settings, row.id, language).absolute() for language in LANGUAGES}
        return order.recording, cell, reports, locate_overlay(settings, row.id).absolute()

    return JobKind(DIAGNOSIS, "server.runner.diagnosing", arguments)


def trials(settings: Settings) -> JobKind:
    """Blind trials. Their seals go into the audit log before the first of them begins: nobody can change what was planted afterwards."""

    def arguments(row: JobRow) -> tuple[object, ...]:
        order = TrialsOrder.model_validate_json(row.order)
        return (settings.trials_folder / row.id).absolute(), order.count, order.seed

    def also(db: Session, row: JobRow) -> None:
        if row.state == JobStatus.running and row.told is not None:
            said: audit.Detail = {"trials": row.id, "count": len(json.loads(row.told)), "sha256": sha256_of(row.told)}
            audit.record(db, row.requested_by, "trials.seal", said)

    return JobKind(TRIALS, "server.runner.trialling", arguments, also)


def sha256_of(text: str | None) -> str:
    """Of what a job told or found, hexadecimal."""
    return sha256((text or "").encode()).hexdigest()
