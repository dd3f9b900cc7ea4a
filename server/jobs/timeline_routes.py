"""Which effect came when: diagnoses of one cell, of runs in the order in which they were made and of recordings as they were uploaded."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from core.gap.answer import Diagnosis
from core.gap.timeline import Timeline, trace_effects
from server.http.dependencies import StoreDep
from server.http.schemas import Answer
from server.jobs import jobs
from server.jobs.jobs import JobStatus
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder
from server.runs.conductor import ConductorDep
from server.runs.tables import JobRow

router = APIRouter(prefix="/api/timeline", tags=["diagnoses"])

RunsQuery = Annotated[
    list[str],
    Query(default_factory=list, alias="run", max_length=50, description="Identifiers of the runs.", examples=[["019ab1c2d3e44f1c2a9be7"]]),
]
DiagnosesQuery = Annotated[
    list[str],
    Query(
        default_factory=list,
        alias="diagnosis",
        max_length=50,
        description="Identifiers of diagnoses of uploaded recordings, each in its place by the time of the upload.",
        examples=[["019ab1c2e0a17d34a06c11"]],
    ),
]


class DiagnosedRecording(Answer):
    """A run with its newest finished diagnosis, or an uploaded recording with its own."""

    run: str | None = Field(description="Identifier of the run; null for an uploaded recording.", examples=["019ab1c2d3e44f1c2a9be7"])
    name: str | None = Field(description="Name of an uploaded recording; null where it has none, and for a run.", examples=["Friday"])
    diagnosis: str = Field(description="Identifier of the diagnosis.", examples=["019ab1c2e0a17d34a06c11"])
    requested_at: datetime = Field(description="When the diagnosis was asked for.", examples=["2026-03-01T09:00:00Z"])


class TimelinePublic(Answer):
    """What several diagnoses tell together."""

    recordings: list[DiagnosedRecording] = Field(
        description="Runs and uploaded recordings that are diagnosed, the earliest first; messages call them 1, 2, 3 ..."
    )
    undiagnosed: list[str] = Field(
        description="Those of the runs without a finished diagnosis, and diagnoses that are not finished; they are left out.",
        examples=[["019ab1c2d3e44f1c2a9be7"]],
    )
    timeline: Timeline = Field(description="Which effect each of `recordings` shows, and what came and went.")


@router.get("")
def read_timeline(store: StoreDep, conductor: ConductorDep, runs: RunsQuery, diagnoses: DiagnosesQuery) -> TimelinePublic:
    """Which unmodelled effect came when: from the newest finished diagnosis of each run, and from those of uploaded recordings."""
    known = [conductor.row_of(run).id for run in runs]
    with store.read() as db:
        found = {run: jobs.find_newest_done(db, DIAGNOSIS, run) for run in known}
        for name in diagnoses:
            row = jobs.load_job(db, DIAGNOSIS, name)
            found[name] = row if row.state == JobStatus.done else None
        # the names of runs and of diagnoses are in their order in time
        rows = [(name, row) for name, row in sorted(found.items()) if row is not None]
        answers = [Diagnosis.model_validate_json(row.result or "") for _, row in rows]
        recordings = [_describe(row) for _, row in rows]
    timeline = trace_effects([f"{k + 1}" for k in range(len(answers))], answers)
    undiagnosed = [name for name, row in sorted(found.items()) if row is None]
    return TimelinePublic(recordings=recordings, undiagnosed=undiagnosed, timeline=timeline)


def _describe(row: JobRow) -> DiagnosedRecording:
    order = DiagnosisOrder.model_validate_json(row.order)
    return DiagnosedRecording(run=row.about, name=order.name, diagnosis=row.id, requested_at=row.requested_at)
