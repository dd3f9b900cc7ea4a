"""Diagnoses: of a run's recording or of an uploaded one, as jobs."""

from __future__ import annotations

from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated

import anyio
from fastapi import APIRouter, Depends, Request, Response
from starlette.status import HTTP_202_ACCEPTED

from core.gap.answer import Diagnosis, Verdict
from core.words.catalogue import Language
from core.words.message import Message
from server.cells.folder import CellsDep
from server.http import downloads
from server.http.dependencies import LimitQuery, NowDep, SettingsDep, StoreDep, set_accepted_headers
from server.http.errors import Conflict
from server.http.schemas import Name, RequestBody
from server.http.zip_body import ZIP, check_is_zip, write_body
from server.jobs import jobs
from server.jobs.answer import JobAnswer
from server.jobs.jobs import DiagnosesDep, Worker
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder, locate_overlay, locate_report
from server.people import audit
from server.people.auth import CallerDep
from server.runner.overlay_schemas import OverlayAnswer
from server.runner.run_folder import RECORDING
from server.runs import ledger as run_ledger
from server.runs.conductor import ConductorDep
from server.runs.recording_archive import unpack_recording
from server.runs.tables import JobRow
from server.store.store import Store

router = APIRouter(prefix="/api/diagnoses", tags=["diagnoses"])

TYPICAL_S = 30


class DiagnosisBody(RequestBody):
    """The run whose recording is to be diagnosed."""

    run: str


class DiagnosisAnswer(JobAnswer):
    """A diagnosis.

    Args:
        cell: where the recording was made, null where that is none of ours.
        verdict, named: the answer, and the effect that is most probable, or two joined by a plus sign; null where it names none.
        also: what is material beside the verdict, elsewhere than in the wrench.
        summary: the same in sentences; `result` is what `heft diagnose --json` writes. Null until it is done.
    """

    diagnosis: str
    run: str | None
    cell: str | None
    verdict: Verdict | None
    named: str | None
    also: list[str]
    summary: Message | None
    result: Diagnosis | None


async def _receive_recording(request: Request, settings: SettingsDep, now: NowDep) -> AsyncIterator[Path]:
    """The folder of an uploaded recording, unpacked; kept, as a run's is."""
    check_is_zip(request, "recording")
    place = settings.recordings_folder / f"upload-{run_ledger.new_id(now)}"
    archive = place.with_suffix(".zip.part")
    try:
        await write_body(request, archive)
        await anyio.to_thread.run_sync(unpack_recording, archive, place)
    finally:
        archive.unlink(missing_ok=True)
    yield place


@router.post("", status_code=HTTP_202_ACCEPTED)
def diagnose_run(
    body: DiagnosisBody,
    response: Response,
    store: StoreDep,
    conductor: ConductorDep,
    settings: SettingsDep,
    diagnoses: DiagnosesDep,
    caller: CallerDep,
    now: NowDep,
) -> DiagnosisAnswer:
    """Asks what parts simulation and recording of a run, and how far it goes away once it is known."""
    folder = settings.recordings_folder / body.run / RECORDING
    row = conductor.row_of(body.run)
    if not folder.is_dir():
        raise Conflict("runs-no-recording", run=body.run, state=row.state)
    return _queue(store, diagnoses, DiagnosisOrder(recording=folder.absolute(), run=body.run, cell=row.cell), caller.who, now, response)


@router.post("/uploads", status_code=HTTP_202_ACCEPTED, openapi_extra=ZIP)
def diagnose_upload(
    folder: Annotated[Path, Depends(_receive_recording)],
    response: Response,
    store: StoreDep,
    cells: CellsDep,
    diagnoses: DiagnosesDep,
    caller: CallerDep,
    now: NowDep,
    cell: Name | None = None,
) -> DiagnosisAnswer:
    """The same of a recording folder as a zip; with the cell it was made in, where that is one of ours."""
    if cell is not None:
        cells.load(cell)
    return _queue(store, diagnoses, DiagnosisOrder(recording=folder.absolute(), cell=cell), caller.who, now, response)


@router.get("")
def list_diagnoses(store: StoreDep, diagnoses: DiagnosesDep, limit: LimitQuery = 50) -> list[DiagnosisAnswer]:
    """Newest first, each with its summary alone."""
    with store.read() as db:
        return [_answer(diagnoses, row, whole=False) for row in jobs.list_jobs(db, DIAGNOSIS, limit)]


@router.get("/{diagnosis}")
def read_diagnosis(diagnosis: str, diagnoses: DiagnosesDep, store: StoreDep) -> DiagnosisAnswer:
    """One diagnosis."""
    with store.read() as db:
        return _answer(diagnoses, jobs.load_job(db, DIAGNOSIS, diagnosis))


@router.delete("/{diagnosis}")
def cancel_diagnosis(diagnosis: str, store: StoreDep, diagnoses: DiagnosesDep, caller: CallerDep, now: NowDep) -> DiagnosisAnswer:
    """Ends a diagnosis that waits or runs; the recording stays."""
    with store.write() as db:
        row = jobs.cancel(db, DIAGNOSIS, diagnosis, caller.who, now)
        audit.record(db, caller.who, "diagnosis.cancel", {"diagnosis": diagnosis}, now=now)
        found = _answer(diagnoses, row)
    diagnoses.drop(diagnosis)
    return found


@router.get("/{diagnosis}/overlay")
def read_overlay(diagnosis: str, store: StoreDep, settings: SettingsDep) -> OverlayAnswer:
    """Measured and simulated before and after, for plots; none where there was too little to compare."""
    with store.read() as db:
        row = jobs.load_job(db, DIAGNOSIS, diagnosis)
    file = locate_overlay(settings, diagnosis)
    if not file.is_file():
        raise Conflict("jobs-no-overlay", job=diagnosis, state=row.state)
    return OverlayAnswer.model_validate_json(file.read_bytes())


@router.get("/{diagnosis}/report", response_class=Response, responses=downloads.PAGE)
def download_diagnosis_report(diagnosis: str, store: StoreDep, settings: SettingsDep, language: Language = "en") -> Response:
    """The diagnosis as a page; in English where it was made before there were other languages."""
    with store.read() as db:
        row = jobs.load_job(db, DIAGNOSIS, diagnosis)
    missing = Message.of("jobs-no-report", job=diagnosis, state=row.state)
    files = [locate_report(settings, diagnosis, language), locate_report(settings, diagnosis, "en")]
    return downloads.page(files, f"diagnosis-{diagnosis}", missing)


def _queue(store: Store, diagnoses: Worker, order: DiagnosisOrder, who: str, now: datetime, response: Response) -> DiagnosisAnswer:
    with store.write() as db:
        row = jobs.add_job(db, DIAGNOSIS, order, order.run, who, now)
        audit.record(db, who, "diagnosis.queue", {"diagnosis": row.id, "run": order.run}, now=now)
        found = _answer(diagnoses, row)
    diagnoses.wake()
    set_accepted_headers(response, f"/api/diagnoses/{found.diagnosis}", TYPICAL_S)
    return found


def _answer(diagnoses: Worker, row: JobRow, *, whole: bool = True) -> DiagnosisAnswer:
    result = None if row.result is None else Diagnosis.model_validate_json(row.result)
    return DiagnosisAnswer.of(
        row,
        diagnoses,
        diagnosis=row.id,
        run=row.about,
        cell=DiagnosisOrder.model_validate_json(row.order).cell,
        verdict=None if result is None else result.verdict,
        named=None if result is None else _find_most_probable(result),
        also=[] if result is None else [each.id for each in result.also if each.material],
        summary=None if result is None else result.summary,
        result=result if whole else None,
    )


def _find_most_probable(result: Diagnosis) -> str | None:
    """What is most probable of the effects and pairs that an answer names."""
    single = [(effect.probability, effect.id) for effect in result.effects]
    both = [(pair.probability, "+".join(pair.ids)) for pair in result.pairs]
    return max(single + both)[1] if single or both else None
