"""Diagnoses: of a run's recording or of an uploaded one, as jobs."""

from __future__ import annotations

from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated, Any

import anyio
from fastapi import APIRouter, Depends, Query, Request, Response
from starlette.status import HTTP_202_ACCEPTED

from core.gap.answer import Diagnosis
from server import audit, downloads, jobs, run_ledger
from server.dependencies import Asking, Here, Now, Stored
from server.errors import Conflict, Unprocessable
from server.job_kinds import DIAGNOSIS, DiagnosisOrder, report_of
from server.jobs import State
from server.recording_archive import unpack
from server.run_tables import JobRow
from server.runner.run_folder import RECORDING
from server.schemas import Answer, Body
from server.service import Service

router = APIRouter(prefix="/api/diagnoses", tags=["diagnoses"])

TYPICAL_S = 30
ZIP: dict[str, Any] = {
    "requestBody": {"required": True, "content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}}}
}


class DiagnosisBody(Body):
    """The run whose recording is to be diagnosed."""

    run: str


class DiagnosisAnswer(Answer):
    """A diagnosis; `result` is what `heft diagnose --json` writes, null until it is done."""

    diagnosis: str
    run: str | None
    state: State
    progress: float
    reason: str | None
    requested_by: str
    requested_at: datetime
    ended_at: datetime | None
    result: Diagnosis | None


async def _uploaded(request: Request, here: Here, now: Now) -> AsyncIterator[Path]:
    """The folder of an uploaded recording, unpacked; kept, as a run's is."""
    kind = request.headers.get("content-type", "").partition(";")[0]
    if kind != "application/zip":
        raise Unprocessable(f"Content-Type: found {kind[:60]!r}, expected application/zip; send a zip of the recording's folder")
    place = here.settings.recordings_folder / f"upload-{run_ledger.new_id(now)}"
    archive = place.with_suffix(".zip.part")
    try:
        async with await anyio.open_file(archive, "wb") as file:
            async for chunk in request.stream():
                await file.write(chunk)
        await anyio.to_thread.run_sync(unpack, archive, place)
    finally:
        archive.unlink(missing_ok=True)
    yield place


@router.post("", status_code=HTTP_202_ACCEPTED)
def diagnose_run(body: DiagnosisBody, response: Response, here: Here, asking: Asking, now: Now) -> DiagnosisAnswer:
    """Asks what parts simulation and recording of a run, and how far it goes away once it is known."""
    folder = here.settings.recordings_folder / body.run / RECORDING
    with here.store.read() as db:
        row = run_ledger.load(db, body.run)
    if not folder.is_dir():
        raise Conflict(f"run {body.run}: has no recording, it is in {row.state}; wait for its end")
    return _queued(here, folder, body.run, asking.who, now, response)


@router.post("/uploads", status_code=HTTP_202_ACCEPTED, openapi_extra=ZIP)
def diagnose_upload(
    folder: Annotated[Path, Depends(_uploaded)], response: Response, here: Here, asking: Asking, now: Now
) -> DiagnosisAnswer:
    """The same of a recording folder as a zip."""
    return _queued(here, folder, None, asking.who, now, response)


@router.get("")
def list_diagnoses(here: Here, limit: Annotated[int, Query(ge=1, le=200)] = 50) -> list[DiagnosisAnswer]:
    """Newest first, without their results."""
    with here.store.read() as db:
        return [_answer(here, row, whole=False) for row in jobs.listed(db, DIAGNOSIS, limit)]


@router.get("/{diagnosis}")
def read_diagnosis(diagnosis: str, here: Here, store: Stored) -> DiagnosisAnswer:
    """One diagnosis."""
    with store.read() as db:
        return _answer(here, jobs.load(db, DIAGNOSIS, diagnosis))


@router.get("/{diagnosis}/report", response_class=Response, responses=downloads.PAGE)
def download_diagnosis_report(diagnosis: str, here: Here) -> Response:
    """The diagnosis as a page."""
    with here.store.read() as db:
        row = jobs.load(db, DIAGNOSIS, diagnosis)
    missing = f"diagnosis {diagnosis}: has no report, it is {row.state}; a report comes with a diagnosis that is done"
    return downloads.page(report_of(here.settings, diagnosis), f"diagnosis-{diagnosis}", missing)


def _queued(here: Service, folder: Path, run: str | None, who: str, now: datetime, response: Response) -> DiagnosisAnswer:
    with here.store.write() as db:
        row = jobs.queue(db, DIAGNOSIS, DiagnosisOrder(recording=folder.absolute(), run=run), run, who, now)
        audit.record(db, who, "diagnosis.queue", {"diagnosis": row.id, "run": run}, now=now)
        found = _answer(here, row)
    here.diagnoses.wake()
    response.headers["Location"] = f"/api/diagnoses/{found.diagnosis}"
    response.headers["Retry-After"] = str(TYPICAL_S)
    return found


def _answer(here: Service, row: JobRow, *, whole: bool = True) -> DiagnosisAnswer:
    return DiagnosisAnswer(
        diagnosis=row.id,
        run=row.about,
        state=State(row.state),
        progress=1.0 if row.state == State.done else here.diagnoses.progress.get(row.id, 0.0),
        reason=row.reason,
        requested_by=row.requested_by,
        requested_at=row.requested_at,
        ended_at=row.ended_at,
        result=Diagnosis.model_validate_json(row.result) if whole and row.result is not None else None,
    )
