"""A run's certificate: one page for the record, and the same as data."""

from __future__ import annotations

from base64 import b64decode

from fastapi import APIRouter, Response

from core.cell.cell import Cell
from core.certificate.certificate import Certificate
from core.errors import BadInput
from core.words.catalogue import Language
from server.cells.folder import CellFolder, CellsDep
from server.http import downloads
from server.http.dependencies import SettingsDep
from server.http.errors import NotFound, Unprocessable
from server.http.parameters import LanguageQuery, RunPath
from server.runner.messages import Answered, Failed
from server.runner.run_folder import RECORDING
from server.runner.work import run_work
from server.runs.conductor import Conductor, ConductorDep
from server.runs.file_routes import make_record, name_after
from server.runs.ledger import load_result
from server.settings import Settings

router = APIRouter(prefix="/api/runs/{run}", tags=["results"])


@router.get("/certificate", response_model=Certificate)
def download_certificate(run: RunPath, cells: CellsDep, conductor: ConductorDep, settings: SettingsDep) -> Response:
    """Who, what, when, with which sensor, values with their budget, statement of conformity; the page names the SHA-256 of these bytes.

    Before somebody has accepted the result it says that nobody has. It takes some seconds.
    """
    content = _certify(cells, conductor, settings, run, None)
    return _send(content, "application/json", f"{name_after(conductor.row_of(run))}-certificate.json")


@router.get("/certificate.pdf", response_class=Response, responses=downloads.PDF)
def download_certificate_page(
    run: RunPath, cells: CellsDep, conductor: ConductorDep, settings: SettingsDep, language: LanguageQuery = "en"
) -> Response:
    """The certificate as a page of A4 to sign and to file; it names the SHA-256 of its data. It takes some seconds."""
    content = _certify(cells, conductor, settings, run, language)
    return _send(content, "application/pdf", f"{name_after(conductor.row_of(run))}-certificate.pdf")


def _certify(cells: CellFolder, conductor: Conductor, settings: Settings, run: str, language: Language | None) -> bytes:
    row = conductor.row_of(run)
    result, cell = load_result(row), _find_cell(cells, row.cell)
    folder = settings.recordings_folder / run / RECORDING
    for word in run_work("server.runner.certifying", result, make_record(row), folder, cell, language):
        match word:
            case Answered(text=text):
                return b64decode(text)
            case Failed(message=message):
                raise Unprocessable(message.code, **message.parameters)
    raise Unprocessable("jobs-work-lost")


def _find_cell(cells: CellFolder, name: str) -> Cell | None:
    """None where it is gone, or cannot be read any more."""
    try:
        return cells.read(name).cell
    except (NotFound, BadInput):
        return None


def _send(content: bytes, media_type: str, name: str) -> Response:
    return Response(content, media_type=media_type, headers={"Content-Disposition": f'attachment; filename="{name}"'})
