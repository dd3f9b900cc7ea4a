"""The cells: what there is, whether it can be used, new ones."""

from __future__ import annotations

from collections.abc import AsyncIterator
from pathlib import Path
from typing import Annotated, Any

import anyio
from fastapi import APIRouter, Depends, Request, Response
from fastapi import Path as InPath

from core.cell import Cell
from server import audit, zones
from server.cell_archive import UPLOAD
from server.cell_uploads import take_in, upload_folder
from server.dependencies import Asking, Cells, Here, Now, Stored
from server.errors import Unprocessable
from server.schemas import Answer, Name

router = APIRouter(prefix="/api/cells", tags=["cells"])

CellName = Annotated[Name, InPath()]
ZIP: dict[str, Any] = {
    "requestBody": {"required": True, "content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}}}
}


class CellListed(Answer):
    """A cell; `flaw` says why it cannot be used."""

    name: str
    title: str | None
    flaw: str | None


class CellShown(Answer):
    """A cell, its protected zones where they are now; `sha256` covers its files."""

    cell: Cell
    sha256: str


class CellTaken(Answer):
    """A cell that was checked, and where there is one, put into its place."""

    name: str
    sha256: str | None


async def _uploaded(request: Request, here: Here) -> AsyncIterator[Path]:
    """The folder with the request's body in it, while the request lasts."""
    kind = request.headers.get("content-type", "")
    if kind.partition(";")[0] != "application/zip":
        raise Unprocessable(f"Content-Type: found {kind[:60]!r}, expected application/zip; send a zip of the cell's folder")
    with upload_folder(here.cells) as folder:
        async with await anyio.open_file(folder / UPLOAD, "wb") as file:
            async for chunk in request.stream():
                await file.write(chunk)
        yield folder


Uploaded = Annotated[Path, Depends(_uploaded)]


@router.get("")
def list_cells(cells: Cells) -> list[CellListed]:
    """All cells."""
    found = [(name, cells.flaw(name)) for name in cells.names()]
    return [CellListed(name=name, title=None if flaw else cells.load(name).title, flaw=flaw) for name, flaw in found]


@router.get("/{cell}")
def read_cell(cell: CellName, cells: Cells, store: Stored) -> CellShown:
    """A cell, its protected zones where they are now."""
    loaded = cells.load(cell)
    with store.read() as db:
        known = zones.positions(db, cell)
    return CellShown(cell=zones.with_zones_where_they_are(loaded, known), sha256=cells.digest(cell))


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
    except Exception:
        counted("refused").inc()
        raise
    counted("taken in").inc()
    sha256 = here.cells.digest(found)
    with here.store.write() as db:
        audit.record(db, asking.who, "cell.create" if name is None else "cell.replace", {"cell": found, "sha256": sha256}, now=now)
    return CellTaken(name=found, sha256=sha256)
