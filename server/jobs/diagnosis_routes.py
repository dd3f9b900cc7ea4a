"""Diagnoses: of a run's recording or of an uploaded one, as jobs."""

from __future__ import annotations

import shutil
from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated

import anyio
from fastapi import APIRouter, Depends, Query, Request, Response
from pydantic import Field, StringConstraints
from starlette.status import HTTP_202_ACCEPTED

from core.errors import HeftError
from core.gap.answer import Diagnosis, Verdict
from core.gap.instruction import Instruction
from core.words.message import Message
from server.cells.folder import CellsDep
from server.http import downloads
from server.http.dependencies import NowDep, SettingsDep, StoreDep, set_accepted_headers
from server.http.errors import Conflict
from server.http.parameters import DiagnosisPath, LanguageQuery, LimitQuery
from server.http.schemas import Name, RequestBody
from server.http.zip_body import ZIP, check_is_zip, write_body
from server.jobs import jobs
from server.jobs.answer import JobPublic
from server.jobs.jobs import DiagnosesDep, Worker
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder, locate_overlay, locate_report
from server.jobs.uploaded_recording import check_made_in
from server.people import audit
from server.people.auth import CallerDep
from server.runner.overlay_schemas import OverlayPublic
from server.runner.run_folder import RECORDING
from server.runs import ledger as run_ledger
from server.runs.conductor import ConductorDep
from server.runs.recording_archive import unpack_recording
from server.runs.tables import JobRow
from server.store.store import Store

router = APIRouter(prefix="/api/diagnoses", tags=["diagnoses"])

TYPICAL_S = 30

UploadName = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=120, pattern=r"^[^\x00-\x1f\x7f]+$")]
"""What somebody calls a recording."""


class DiagnosisCreate(RequestBody):
    """The run whose recording is to be diagnosed."""

    run: str = Field(description="Identifier of the run whose recording is to be diagnosed.", examples=["019ab1c2d3e44f1c2a9be7"])


class DiagnosisPublic(JobPublic):
    """A diagnosis."""

    diagnosis: str = Field(description="Identifier of the diagnosis; sorts by the time of its making.", examples=["019ab1c2e0a17d34a06c11"])
    run: str | None = Field(
        description="The run whose recording it is of; null for one that was uploaded.", examples=["019ab1c2d3e44f1c2a9be7"]
    )
    cell: str | None = Field(description="Where the recording was made; null where that is none of ours.", examples=["lwr4_bench"])
    tool: str | None = Field(description="What the robot carried; null where that is not known.", examples=["steel_block"])
    name: str | None = Field(
        description="Name that an uploaded recording was given; null for one of a run.", examples=["Friday, new cable"]
    )
    where: Message | None = Field(
        description="Where the gap is largest: known long before its cause; null before that, and where there is too little to compare."
    )
    verdict: Verdict | None = Field(description="The answer in one word; null until it is done.")
    named: str | None = Field(
        description="The effect that is most probable, or two or three joined by plus signs; null where it names none.",
        examples=["time_delay"],
    )
    also: list[str] = Field(description="What is material beside the verdict, elsewhere than in the wrench.", examples=[["joint_backlash"]])
    instruction: Instruction | None = Field(description="What the person at the robot has to do; null until it is done.")
    summary: Message | None = Field(description="The answer in a sentence; null until it is done.")
    result: Diagnosis | None = Field(description="What `heft diagnose --json` writes; null until it is done, and in lists.")


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
    body: DiagnosisCreate,
    response: Response,
    store: StoreDep,
    conductor: ConductorDep,
    settings: SettingsDep,
    diagnoses: DiagnosesDep,
    caller: CallerDep,
    now: NowDep,
) -> DiagnosisPublic:
    """Asks what parts simulation and recording of a run, and how far it goes away once it is known."""
    folder = settings.recordings_folder / body.run / RECORDING
    row = conductor.row_of(body.run)
    if not folder.is_dir():
        raise Conflict("runs-no-recording", run=body.run, state=row.state)
    order = DiagnosisOrder(recording=folder.absolute(), run=body.run, cell=row.cell, tool=row.payload)
    return queue_diagnosis(store, diagnoses, order, caller.who, now, response)


@router.post("/uploads", status_code=HTTP_202_ACCEPTED, openapi_extra=ZIP)
def diagnose_upload(
    folder: Annotated[Path, Depends(_receive_recording)],
    response: Response,
    store: StoreDep,
    cells: CellsDep,
    diagnoses: DiagnosesDep,
    caller: CallerDep,
    now: NowDep,
    cell: Annotated[
        Name | None, Query(description="Name of the cell that it was made in, where that is one of ours.", examples=["lwr4_bench"])
    ] = None,
    name: Annotated[UploadName | None, Query(description="What to call it.", examples=["Friday, new cable"])] = None,
) -> DiagnosisPublic:
    """The same of a recording folder as a zip, under a name; with the cell it was made in, where that is one of ours and its robot is that
    cell's."""
    tool = None
    if cell is not None:
        try:
            tool = check_made_in(folder, cells.load(cell))
        except HeftError:
            shutil.rmtree(folder)
            raise
    order = DiagnosisOrder(recording=folder.absolute(), cell=cell, tool=tool, name=name)
    return queue_diagnosis(store, diagnoses, order, caller.who, now, response)


@router.get("")
def list_diagnoses(store: StoreDep, diagnoses: DiagnosesDep, limit: LimitQuery = 50) -> list[DiagnosisPublic]:
    """Newest first, each with its summary alone."""
    with store.read() as db:
        return [_answer(diagnoses, row, whole=False) for row in jobs.list_jobs(db, DIAGNOSIS, limit)]


@router.get("/{diagnosis}")
def read_diagnosis(diagnosis: DiagnosisPath, diagnoses: DiagnosesDep, store: StoreDep) -> DiagnosisPublic:
    """One diagnosis."""
    with store.read() as db:
        return _answer(diagnoses, jobs.load_job(db, DIAGNOSIS, diagnosis))


@router.delete("/{diagnosis}")
def cancel_diagnosis(diagnosis: DiagnosisPath, store: StoreDep, diagnoses: DiagnosesDep, caller: CallerDep, now: NowDep) -> DiagnosisPublic:
    """Ends a diagnosis that waits or runs; the recording stays."""
    with store.write() as db:
        row = jobs.cancel(db, DIAGNOSIS, diagnosis, caller.who, now)
        audit.record(db, caller.who, "diagnosis.cancel", {"diagnosis": diagnosis}, now=now)
        found = _answer(diagnoses, row)
    diagnoses.drop(diagnosis)
    return found


@router.get("/{diagnosis}/overlay")
def read_overlay(diagnosis: DiagnosisPath, store: StoreDep, settings: SettingsDep) -> OverlayPublic:
    """Measured and simulated before and after, for plots; none where there was too little to compare."""
    with store.read() as db:
        row = jobs.load_job(db, DIAGNOSIS, diagnosis)
    file = locate_overlay(settings, diagnosis)
    if not file.is_file():
        raise Conflict("jobs-no-overlay", job=diagnosis, state=row.state)
    return OverlayPublic.model_validate_json(file.read_bytes())


@router.get("/{diagnosis}/report", response_class=Response, responses=downloads.PAGE)
def download_diagnosis_report(diagnosis: DiagnosisPath, store: StoreDep, settings: SettingsDep, language: LanguageQuery = "en") -> Response:
    """The diagnosis as a page; in English where it was made before there were other languages."""
    with store.read() as db:
        row = jobs.load_job(db, DIAGNOSIS, diagnosis)
    missing = Message.of("jobs-no-report", job=diagnosis, state=row.state)
    files = [locate_report(settings, diagnosis, language), locate_report(settings, diagnosis, "en")]
    order = DiagnosisOrder.model_validate_json(row.order)
    name = downloads.name_file("diagnosis", order.run or order.name or row.id, order.tool, when=row.ended_at or row.requested_at)
    return downloads.page(files, name, missing)


def queue_diagnosis(
    store: Store,
    diagnoses: Worker,
    order: DiagnosisOrder,
    who: str,
    now: datetime,
    response: Response,
    imported: audit.Detail | None = None,
) -> DiagnosisPublic:
    """A diagnosis that waits for its turn.

    Args:
        response: is told where it is.
        imported: the files of the log that its recording was made of, with their SHA-256, for the audit log.
    """
    with store.write() as db:
        if imported is not None:
            audit.record(db, who, "recording.import", {"recording": order.recording.name, **imported}, now=now)
        row = jobs.add_job(db, DIAGNOSIS, order, order.run, who, now)
        audit.record(db, who, "diagnosis.queue", {"diagnosis": row.id, "run": order.run}, now=now)
        found = _answer(diagnoses, row)
    diagnoses.wake()
    set_accepted_headers(response, f"/api/diagnoses/{found.diagnosis}", TYPICAL_S)
    return found


def _answer(diagnoses: Worker, row: JobRow, *, whole: bool = True) -> DiagnosisPublic:
    result = None if row.result is None else Diagnosis.model_validate_json(row.result)
    order = DiagnosisOrder.model_validate_json(row.order)
    return DiagnosisPublic.of(
        row,
        diagnoses,
        diagnosis=row.id,
        run=row.about,
        cell=order.cell,
        tool=order.tool,
        name=order.name,
        where=None if row.told is None else Message.model_validate_json(row.told),
        verdict=None if result is None else result.verdict,
        named=None if result is None else _find_most_probable(result),
        also=[] if result is None else [each.id for each in result.also if each.material],
        instruction=None if result is None else result.instruction,
        summary=None if result is None else result.summary,
        result=result if whole else None,
    )


def _find_most_probable(result: Diagnosis) -> str | None:
    """What is most probable of the effects and pairs that an answer names."""
    single = [(effect.probability, effect.id) for effect in result.effects]
    both = [(pair.probability, "+".join(pair.ids)) for pair in result.pairs]
    return max(single + both)[1] if single or both else None
