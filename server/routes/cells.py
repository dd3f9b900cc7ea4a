"""The cells: what there is, whether it can be used, new ones."""

from __future__ import annotations

from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from fastapi import Path as InPath

from core.cell import Cell
from core.errors import HeftError
from server import audit, zones
from server.cell_archive import UPLOAD
from server.cell_uploads import take_in, upload_folder
from server.dependencies import Asking, Cells, Here, Now, Stored
from server.schemas import Answer, Name
from server.zip_body import ZIP, check_is_zip, write_body

router = APIRouter(prefix="/api/cells", tags=["cells"])

CellName = Annotated[Name, InPath()]


class CellListed(Answer):
    """A cell; `flaw` says why it cannot be used."""

    name: str
    title: str | None
    flaw: str | None


class ZonePlace(Answer):
    """When a zone was brought to where it is now, and by whom: measured by the clock of who measured it, received by ours."""

    zone: str
    moves: int
    moved_by: str
    measured_at: datetime
    received_at: datetime


class CellShown(Answer):
    """A cell, its protected zones where they are now; `sha256` covers its files.

    Args:
        moved: the zones that are no longer where the cell's file has them.
        read_at: the service's clock, for who measures zones and has none of their own that agrees.
    """

    cell: Cell
    sha256: str
    moved: list[ZonePlace]
    read_at: datetime


class CellTaken(Answer):
    """A cell that was checked, and where there is one, put into its place."""

    name: str
    sha256: str | None


async def _uploaded(request: Request, here: Here) -> AsyncIterator[Path]:
    """The folder with the request's body in it, while the request lasts."""
    check_is_zip(request, "cell")
    with upload_folder(here.cells) as folder:
        await write_body(request, folder / UPLOAD)
        yield folder


Uploaded = Annotated[Path, Depends(_uploaded)]


@router.get("")
def list_cells(cells: Cells) -> list[CellListed]:
    """All cells."""
    found = [(name, cells.flaw(name)) for name in cells.names()]
    return [CellListed(name=name, title=None if flaw else cells.load(name).title, flaw=flaw) for name, flaw in found]


@router.get("/{cell}")
def read_cell(cell: CellName, cells: Cells, store: Stored, now: Now) -> CellShown:
    """A cell, its protected zones where they are now."""
    loaded = cells.load(cell)
    with store.read() as db:
        known = zones.positions(db, cell)
        moved = [ZonePlace.model_validate(row) for zone, row in known.items() if any(zone == each.name for each in loaded.zones)]
    there = zones.with_zones_where_they_are(loaded, known)
    return CellShown(cell=there, sha256=cells.digest(cell), moved=moved, read_at=now)


@router.post("/validate", openapi_extra=ZIP)
def validate_cell(folder: Uploaded, here: Here) -> CellTaken:
    """Checks a zip of a cell and keeps nothing."""
    name = here.checker.check(folder)
    return CellTaken(name=name, sha256=None)


@router.post("", status_code=201, openapi_extra=ZIP)
def create_cell(folder: Uploaded, here: Here, asking: Asking, now: Now, response: Response) -> CellTaken:
    """Takes a new cell in."""
    taken = _take_in(here, folder, None, asking, now)
    response.headers["Location"] = f"/api/cells/{taken.name}"
    return taken


@router.put("/{cell}", openapi_extra=ZIP)
def replace_cell(cell: CellName, folder: Uploaded, here: Here, asking: Asking, now: Now) -> CellTaken:
    """Takes a cell in, in place of the one of that name."""
    return _take_in(here, folder, cell, asking, now)


def _take_in(here: Here, folder: Path, name: str | None, asking: Asking, now: Now) -> CellTaken:
    counted = here.metrics.cells_checked.labels
    try:
        found = take_in(here.checker, here.cells, folder, name=name)
    except HeftError:
        counted("refused").inc()
        raise
    counted("taken in").inc()
    sha256 = here.cells.digest(found)
    with here.store.write() as db:
        audit.record(db, asking.who, "cell.create" if name is None else "cell.replace", {"cell": found, "sha256": sha256}, now=now)
    return CellTaken(name=found, sha256=sha256)
