"""A log of another program, step by step: its files, what it is taken for, what has to be answered, the recording that comes of it."""

from __future__ import annotations

import shutil
from collections.abc import AsyncIterator
from contextlib import nullcontext
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from pydantic import Field, StringConstraints
from starlette.status import HTTP_202_ACCEPTED

from core.words.message import Message
from server.cells.folder import CellsDep
from server.http import downloads
from server.http.dependencies import NowDep, SettingsDep, StoreDep
from server.http.errors import Conflict, NotFound
from server.http.parameters import ImportPath, LanguageQuery, LogFilePath
from server.http.schemas import Answer, Name, RequestBody
from server.http.zip_body import FILE_OR_ZIP, check_is_upload
from server.imports.identification import identify_import, require_identified
from server.imports.imports import ImportsDep, LogImport
from server.imports.log_reading import check_understood, read_import
from server.imports.sent_file import FileKind, check_file_name, check_room, receive_file, remove_file
from server.jobs.diagnosis_routes import DiagnosisPublic, UploadName, queue_diagnosis
from server.jobs.jobs import DiagnosesDep
from server.jobs.kinds import DiagnosisOrder
from server.jobs.uploaded_recording import check_made_in
from server.people.auth import CallerDep
from server.runner.log_folder import MAPPING, locate_report
from server.runner.log_schemas import LogReading
from server.runs import ledger as run_ledger
from server.runs.payload_answer import IdentificationPublic, payload_answer

router = APIRouter(prefix="/api/imports", tags=["imports"])

MOST_FILES = 8
Value = Annotated[str, StringConstraints(max_length=200)]


class LogFilePublic(Answer):
    """A file that was sent."""

    file: str = Field(description="Its name.", examples=["wrench.csv"])
    kind: FileKind = Field(description="What it is by its name: a log, a mapping (map.toml), or a robot's description (URDF).")
    size_bytes: int = Field(description="Its size, bytes.", examples=[1_204_331])


class ImportPublic(Answer):
    """A log that is being imported; it is gone when it was diagnosed or deleted, or when nobody has asked for it for some time."""

    log_import: str = Field(description="Identifier of the import.", examples=["9f86d081884c7d659a2feaa0"])
    files: list[LogFilePublic] = Field(description="What was sent.")
    cell: str | None = Field(description="Cell in which it was made; null where that is none of ours.", examples=["lwr4_bench"])
    answers: dict[str, str] = Field(
        description="Keys of the mapping that were given for what was read last.", examples=[{"wrench.sign": "-1"}]
    )
    progress: float | None = Field(description="Share of the reading that is done, 0 to 1; null while nothing is read.", examples=[0.3])
    reading: LogReading | None = Field(description="How far it is understood; null before it was read.")
    identified: IdentificationPublic | None = Field(
        description="The payload with its uncertainties; null before it was identified, or when the log was read anew since."
    )
    without: list[str] = Field(
        description="Files of the log without the payload that it was compared with for that; none where it was identified alone.",
        examples=[["arm alone.csv"]],
    )
    expires_at: datetime = Field(description="When it is gone unless somebody asks for it.", examples=["2026-03-01T10:00:00Z"])


class LogReadingUpdate(RequestBody):
    """What is known of a log beside its files."""

    cell: Name | None = Field(
        default=None,
        description="Cell in which it was made: its robot is the log's; null where that is none of ours.",
        examples=["lwr4_bench"],
    )
    answers: dict[Annotated[str, StringConstraints(max_length=80)], Value] = Field(
        default_factory=dict,
        max_length=40,
        description="Keys of the mapping (docs/import.md) with their values: answers, and what was taken wrongly.",
        examples=[{"wrench.sign": "-1"}],
    )


class LogIdentificationCreate(RequestBody):
    """What the payload is to be identified from beside the log itself."""

    without: Annotated[str, StringConstraints(max_length=80)] | None = Field(
        default=None,
        description="Identifier of the import of a log of the same arm without the payload: it is identified from the joint torques "
        "in both, as by `heft identify --without`; null for the log alone.",
        examples=["5df6e0e2761359d30a8275058e299fcc"],
    )


class LogDiagnosisCreate(RequestBody):
    """The recording that was made of the log is to be diagnosed."""

    name: UploadName | None = Field(default=None, description="What to call it.", examples=["Friday, new cable"])


def find_import(log_import: ImportPath, imports: ImportsDep, now: NowDep) -> LogImport:
    """The import that a request names."""
    return imports.find(log_import, now)


ImportDep = Annotated[LogImport, Depends(find_import)]


async def _receive_file(
    request: Request, file: LogFilePath, log_import: ImportPath, imports: ImportsDep, settings: SettingsDep, now: NowDep
) -> AsyncIterator[LogImport]:
    """The import with the request's body among its files."""
    found = imports.find(log_import, now)
    check_is_upload(request, "log")
    check_file_name(file)
    with found.working():
        if len(found.files) >= MOST_FILES and file not in found.files:
            raise Conflict("imports-too-many-files", log_import=found.id, most_files=MOST_FILES)
        check_room(found.folder, settings.upload_max_bytes)
        found.forget_reading()
        if found.files.pop(file, None) is not None:
            remove_file(file, found.logs)
        found.files[file] = await receive_file(file, request.stream(), found.logs)
    yield found


@router.post("", status_code=201)
def begin_import(imports: ImportsDep, now: NowDep, response: Response) -> ImportPublic:
    """Begins an import; its files follow."""
    with imports.begin(now) as found:
        found.logs.mkdir()
    response.headers["Location"] = f"/api/imports/{found.id}"
    return _answer(found, imports, now)


@router.get("/{log_import}")
def read_log_import(found: ImportDep, imports: ImportsDep, now: NowDep) -> ImportPublic:
    """How far it is."""
    return _answer(found, imports, now)


@router.delete("/{log_import}", status_code=204)
def delete_import(found: ImportDep, imports: ImportsDep) -> None:
    """Leaves it; nothing of it stays."""
    with found.working():
        imports.remove(found)


@router.put("/{log_import}/files/{file}", openapi_extra=FILE_OR_ZIP)
def send_log_file(found: Annotated[LogImport, Depends(_receive_file)], imports: ImportsDep, now: NowDep) -> ImportPublic:
    """Sends a file of the log: CSV, Parquet, MCAP, a bag of ROS, a zip of a bag's folder; map.toml; the robot's URDF. One of the same name
    is replaced."""
    return _answer(found, imports, now)


@router.delete("/{log_import}/files/{file}")
def delete_log_file(file: LogFilePath, found: ImportDep, imports: ImportsDep, now: NowDep) -> ImportPublic:
    """Takes a file away again."""
    with found.working():
        if found.files.pop(file, None) is None:
            raise NotFound("imports-file-unknown", file=file[:120])
        remove_file(file, found.logs)
        found.forget_reading()
    return _answer(found, imports, now)


@router.put("/{log_import}/reading")
def read_log_anew(found: ImportDep, body: LogReadingUpdate, imports: ImportsDep, cells: CellsDep, now: NowDep) -> ImportPublic:
    """Reads the log with what is known of it: the answer has what it was taken for, or the next question. Meanwhile the import tells how
    far it is."""
    read_import(found, cells, body.cell, body.answers)
    return _answer(found, imports, now)


@router.get("/{log_import}/mapping", response_class=Response, responses=downloads.TEXT)
def download_mapping(found: ImportDep) -> Response:
    """The mapping with which it was read, as map.toml: `heft import --map` takes it, and so does the next import of such a log."""
    check_understood(found)
    return downloads.text((found.recording / MAPPING).read_text(encoding="utf-8"), MAPPING)


@router.get("/{log_import}/recording", response_class=Response, responses=downloads.ZIPPED)
def download_imported_recording(found: ImportDep, now: NowDep) -> Response:
    """The recording that was made of it, as a zip: `heft identify` takes the folder in it."""
    check_understood(found)
    name = downloads.name_file("recording", next(iter(found.files), None), when=now)
    return downloads.send_zip(found.recording, name, Message.of("imports-not-read", log_import=found.id))


@router.post("/{log_import}/identification")
def identify_imported_log(
    found: ImportDep, imports: ImportsDep, cells: CellsDep, now: NowDep, body: LogIdentificationCreate | None = None
) -> ImportPublic:
    """Identifies the payload from the recording that was made of it, as `heft identify` does, alone or beside one of the same arm without
    the payload; both stay until they are diagnosed or deleted."""
    empty = None if body is None or body.without is None else imports.find(body.without, now)
    if empty is found:
        raise Conflict("imports-without-itself", log_import=found.id)
    with found.working(), nullcontext() if empty is None else empty.working():
        for each in (found, *(() if empty is None else (empty,))):
            check_understood(each)
        cell = None if found.cell is None else cells.load(found.cell)
        if cell is not None:
            check_made_in(found.recording, cell)
        identify_import(found, cell, empty)
    return _answer(found, imports, now)


@router.get("/{log_import}/result", response_class=Response, responses=downloads.TEXT)
def download_import_result(found: ImportDep, now: NowDep) -> Response:
    """What `heft identify --json` writes of it: `heft export` and `heft compare` take it."""
    name = downloads.name_file("result", next(iter(found.files), None), when=now)
    return downloads.text(require_identified(found).model_dump_json(indent=2) + "\n", f"{name}.json")


@router.get("/{log_import}/report", response_class=Response, responses=downloads.PAGE)
def download_import_report(found: ImportDep, now: NowDep, language: LanguageQuery = "en") -> Response:
    """The payload that was identified from it as a page."""
    require_identified(found)
    name = downloads.name_file("report", next(iter(found.files), None), when=now)
    return downloads.page([locate_report(found.folder, language)], name, Message.of("imports-not-identified", log_import=found.id))


@router.post("/{log_import}/diagnosis", status_code=HTTP_202_ACCEPTED)
def diagnose_import(
    found: ImportDep,
    body: LogDiagnosisCreate,
    response: Response,
    imports: ImportsDep,
    store: StoreDep,
    cells: CellsDep,
    settings: SettingsDep,
    diagnoses: DiagnosesDep,
    caller: CallerDep,
    now: NowDep,
) -> DiagnosisPublic:
    """Keeps the recording as an uploaded one, and diagnoses it; the import is gone then."""
    with found.working():
        check_understood(found)
        tool = None if found.cell is None else check_made_in(found.recording, cells.load(found.cell))
        place = settings.recordings_folder.absolute() / f"upload-{run_ledger.new_id(now)}"
        found.recording.replace(place)
        order = DiagnosisOrder(recording=place, cell=found.cell, tool=tool, name=body.name)
        said = {f"file_{k}": f"{name} {sent.sha256}" for k, (name, sent) in enumerate(found.files.items(), start=1)}
        try:
            queued = queue_diagnosis(store, diagnoses, order, caller.who, now, response, said)
        except BaseException:
            shutil.rmtree(place, ignore_errors=True)
            found.reading = None
            raise
        imports.remove(found)
    return queued


def _answer(found: LogImport, imports: ImportsDep, now: datetime) -> ImportPublic:
    return ImportPublic(
        log_import=found.id,
        files=[LogFilePublic(file=name, kind=sent.kind, size_bytes=sent.size_bytes) for name, sent in found.files.items()],
        cell=found.cell,
        answers=found.answers,
        progress=found.progress,
        reading=found.reading,
        identified=None if found.identified is None else payload_answer(found.identified),
        without=list(found.without),
        expires_at=now + imports.lasts,
    )
