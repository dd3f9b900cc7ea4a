"""Which effect came when: the diagnoses of several runs of one cell, in the order in which the runs were made."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from core.gap.answer import Diagnosis
from core.gap.timeline import Timeline, trace_effects
from server.http.dependencies import StoreDep
from server.http.schemas import Answer
from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS
from server.runs.conductor import ConductorDep

router = APIRouter(prefix="/api/timeline", tags=["diagnoses"])

RunsQuery = Annotated[
    list[str],
    Query(alias="run", min_length=1, max_length=50, description="Identifiers of the runs.", examples=[["019ab1c2d3e44f1c2a9be7"]]),
]


class DiagnosedRun(Answer):
    """A run with its newest finished diagnosis."""

    run: str = Field(description="Identifier of the run.", examples=["019ab1c2d3e44f1c2a9be7"])
    diagnosis: str = Field(description="Identifier of the diagnosis.", examples=["019ab1c2e0a17d34a06c11"])


class TimelinePublic(Answer):
    """What the diagnoses of several runs tell together."""

    runs: list[DiagnosedRun] = Field(description="The runs that are diagnosed, the earliest first; messages call them 1, 2, 3 ...")
    undiagnosed: list[str] = Field(
        description="Those of the runs without a finished diagnosis; they are left out.", examples=[["019ab1c2d3e44f1c2a9be7"]]
    )
    timeline: Timeline = Field(description="Which effect each of `runs` shows, and what came and went.")


@router.get("")
def read_timeline(runs: RunsQuery, store: StoreDep, conductor: ConductorDep) -> TimelinePublic:
    """Which unmodelled effect came when: from the newest finished diagnosis of each run."""
    # the names of runs are in their order in time
    names = [conductor.row_of(run).id for run in sorted(set(runs))]
    with store.read() as db:
        found = {run: row for run in names if (row := jobs.find_newest_done(db, DIAGNOSIS, run)) is not None}
        answers = [Diagnosis.model_validate_json(row.result or "") for row in found.values()]
        diagnosed = [DiagnosedRun(run=run, diagnosis=row.id) for run, row in found.items()]
    timeline = trace_effects([f"{k + 1}" for k in range(len(answers))], answers)
    return TimelinePublic(runs=diagnosed, undiagnosed=[run for run in names if run not in found], timeline=timeline)
