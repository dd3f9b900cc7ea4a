"""What a run leaves behind as files: its recording, its report."""

from __future__ import annotations

from fastapi import APIRouter, Response
from fastapi.responses import HTMLResponse

from core.estimation.result import Result
from core.report.record import Record, put_record
from core.version import release_version
from core.words.catalogue import LANGUAGES
from core.words.message import Message
from core.words.wording import Wording
from server.http import downloads
from server.http.dependencies import SettingsDep
from server.http.errors import Conflict
from server.http.parameters import LanguageQuery, RunPath
from server.runner.run_folder import RECORDING, name_report
from server.runs.conductor import ConductorDep
from server.runs.ledger import read_plan_sha256
from server.runs.order import reference_of
from server.runs.tables import RunRow

router = APIRouter(prefix="/api/runs/{run}", tags=["runs"])


@router.get("/recording", response_class=Response, responses=downloads.ZIPPED)
def download_recording(run: RunPath, conductor: ConductorDep, settings: SettingsDep) -> Response:
    """The samples of a run as a zip of its recording folder; also of one that ended early."""
    row = conductor.row_of(run)
    missing = Message.of("runs-no-recording", run=run, state=row.state)
    return downloads.send_zip(settings.recordings_folder / run / RECORDING, name_after(row), missing)


@router.get("/report", response_class=Response, responses=downloads.PAGE)
def download_report(run: RunPath, conductor: ConductorDep, settings: SettingsDep, language: LanguageQuery = "en") -> Response:
    """The report of a run that came through, as a page; in English where it was made before there were other languages."""
    row = conductor.row_of(run)
    folder = settings.recordings_folder / run
    found = next((each for each in (language, *LANGUAGES) if (folder / name_report(each)).is_file()), None)
    if found is None:
        raise Conflict("runs-no-report", run=run, state=row.state)
    page = put_record((folder / name_report(found)).read_text(encoding="utf-8"), make_record(row), Wording(found))
    headers = {"Content-Disposition": f'attachment; filename="{name_after(row)}.html"'} | downloads.HARMLESS
    return HTMLResponse(page, headers=headers)


def make_record(row: RunRow) -> Record:
    """What a run's report says of itself, as far as it is known by now."""
    result = None if row.result is None else Result.model_validate_json(row.result)
    return Record(
        at=row.ended_at or row.requested_at,
        cell=row.cell,
        version=(None if result is None else result.version) or release_version(),
        plan_sha256=read_plan_sha256(row),
        order=reference_of(row),
        run=row.id,
        operator=row.released_by,
        accepted_by=row.accepted_by,
        accepted_at=row.accepted_at,
    )


def name_after(row: RunRow) -> str:
    """What a file of a run is called, without its ending: run, tool, day."""
    return downloads.name_file("run", row.id, row.payload, when=row.ended_at or row.requested_at)
