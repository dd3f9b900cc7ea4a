"""The cells: what there is, whether it can be used, new ones."""

from __future__ import annotations

from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from pydantic import Field
from sqlalchemy.orm import Session

from core.cell.cell import Cell
from core.cell.folder import CellRead
from core.errors import BadInput, BadTwin
from core.payload.shapes import StandingShape
from core.words.message import Message
from server.cells import zones
from server.cells.archive import UPLOAD
from server.cells.folder import CellFolder, CellsDep
from server.cells.now import read_now
from server.cells.tool_outlines import ToolOutline, ToolOutlinesDep
from server.cells.uploads import CheckerDep, import_cell, upload_folder
from server.cells.zones import ZonePosition
from server.http.dependencies import MetricsDep, NowDep, StoreDep
from server.http.flaws import Flaw, list_flaws
from server.http.parameters import CellPath
from server.http.schemas import Answer
from server.http.zip_body import ZIP, check_is_zip, write_body
from server.people.auth import CallerDep

router = APIRouter(prefix="/api/cells", tags=["cells"])


class CellSummary(Answer):
    """A cell; `flaw` says why nothing can be planned in it now, `flaws` says all of it."""

    name: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    title: str | None = Field(description="What people call it; null where its file cannot be read.", examples=["LWR 4 on the bench"])
    flaw: Message | None = Field(description="Why nothing can be planned in it now; null where something can.")
    flaws: list[Flaw] = Field(description="All that is wrong with it now.")


class ZonePlace(Answer):
    """When a zone became what it is now, and by whom: measured by the clock of who measured it, received by ours."""

    zone: str = Field(description="Name of the zone.", examples=["operator"])
    moves: int = Field(description="How often it has changed.", examples=[3])
    moved_by: str = Field(description="Who moved, drew or removed it.", examples=["key:tracker"])
    measured_at: datetime = Field(description="When it was measured, by the clock of who did.", examples=["2026-03-01T08:00:00Z"])
    received_at: datetime = Field(description="When the service heard of it, by its own clock.", examples=["2026-03-01T08:00:00.120Z"])
    previous: StandingShape | None = Field(description="How it was before, world frame; null where there was none.")
    in_file: StandingShape | None = Field(description="How the cell's file has it, world frame; null where it has none of that name.")


class CellPublic(Answer):
    """A cell, its protected zones where they are now; `sha256` covers its files."""

    cell: Cell | None = Field(
        description="The cell with its zones where they are now; null where its `cell.toml` cannot be read, then `flaws` says why."
    )
    flaws: list[Flaw] = Field(description="Why nothing can be planned in it now, be it the fault of its files or of where its zones are.")
    in_the_way: list[str] = Field(description="Obstacles and zones that stand where the robot's base is.", examples=[["operator"]])
    drawn: bool = Field(description="Whether `/viewer/{cell}/` can show it, which takes a sound robot.")
    sha256: str = Field(
        description="SHA-256 of its files, hexadecimal.", examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"]
    )
    moved: list[ZonePlace] = Field(description="Zones that were moved, drawn or removed here; those removed are not in `cell`.")
    read_at: datetime = Field(
        description="The service's clock, for who measures zones and has none that agrees.", examples=["2026-03-01T08:00:00Z"]
    )


class CellVersion(Answer):
    """A cell that was checked, and where there is one, put into its place."""

    name: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    sha256: str | None = Field(
        description="SHA-256 of its files, hexadecimal; null where it was only checked.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )


async def _receive_upload(request: Request, cells: CellsDep) -> AsyncIterator[Path]:
    """The folder with the request's body in it, while the request lasts."""
    check_is_zip(request, "cell")
    with upload_folder(cells) as folder:
        await write_body(request, folder / UPLOAD)
        yield folder


UploadDep = Annotated[Path, Depends(_receive_upload)]


@router.get("")
def list_cells(cells: CellsDep, store: StoreDep) -> list[CellSummary]:
    """All cells, also those in which nothing can be planned."""
    with store.read() as db:
        return [_summarise(name, *_inspect(cells, db, name)) for name in cells.names()]


@router.get("/{cell}")
def read_cell(cell: CellPath, cells: CellsDep, store: StoreDep, now: NowDep) -> CellPublic:
    """A cell, its protected zones where they are now, and what speaks against planning in it."""
    with store.read() as db:
        cell_read, flaws = _inspect(cells, db, cell)
        known = zones.positions(db, cell)
    in_file = None if cell_read is None else cells.read(cell).cell
    return CellPublic(
        cell=None if cell_read is None else cell_read.cell,
        flaws=list_flaws(flaws),
        in_the_way=[flaw.in_the_way for flaw in flaws if flaw.in_the_way is not None],
        drawn=cell_read is not None and not cell_read.robot_flaws,
        sha256=cells.digest(cell),
        moved=[] if in_file is None else _list_places(known, in_file),
        read_at=now,
    )


@router.get("/{cell}/tools")
def list_tools(cell: CellPath, cells: CellsDep, outlines: ToolOutlinesDep) -> list[ToolOutline]:
    """What is bolted between the sensor and the payload, as boxes in the sensor frame, in the order of `cell.toml`."""
    return outlines.find(cells.read(cell).cell, cells.digest(cell))


@router.post("/validate", openapi_extra=ZIP)
def validate_cell(folder: UploadDep, checker: CheckerDep) -> CellVersion:
    """Checks a zip of a cell and keeps nothing."""
    name = checker.check(folder)
    return CellVersion(name=name, sha256=None)


@router.post("", status_code=201, openapi_extra=ZIP)
def create_cell(
    folder: UploadDep,
    store: StoreDep,
    cells: CellsDep,
    metrics: MetricsDep,
    checker: CheckerDep,
    caller: CallerDep,
    now: NowDep,
    response: Response,
) -> CellVersion:
    """Takes a new cell in."""
    name, sha256 = import_cell(store, cells, metrics, checker, folder, None, caller.who, now)
    response.headers["Location"] = f"/api/cells/{name}"
    return CellVersion(name=name, sha256=sha256)


@router.put("/{cell}", openapi_extra=ZIP)
def replace_cell(
    cell: CellPath,
    folder: UploadDep,
    store: StoreDep,
    cells: CellsDep,
    metrics: MetricsDep,
    checker: CheckerDep,
    caller: CallerDep,
    now: NowDep,
) -> CellVersion:
    """Takes a cell in, in place of the one of that name."""
    name, sha256 = import_cell(store, cells, metrics, checker, folder, cell, caller.who, now)
    return CellVersion(name=name, sha256=sha256)


def _inspect(cells: CellFolder, db: Session, name: str) -> tuple[CellRead | None, list[BadInput]]:
    """A cell as it is now, None where it cannot be read, and all that is wrong with it and its twin.

    Raises:
        NotFound: there is none of that name.
    """
    try:
        cell_read = read_now(cells, db, name)
    except BadInput as error:
        return None, [error, *error.others]
    flaws = cells.flaws(cell_read)
    try:
        cells.read_twin(cell_read.cell)
    except BadTwin as error:
        flaws.append(error)
    return cell_read, flaws


def _summarise(name: str, cell_read: CellRead | None, flaws: list[BadInput]) -> CellSummary:
    title = None if cell_read is None else cell_read.cell.title
    return CellSummary(name=name, title=title, flaw=flaws[0].message if flaws else None, flaws=list_flaws(flaws))


def _list_places(known: dict[str, ZonePosition], cell: Cell) -> list[ZonePlace]:
    """Of zones that there are, or were: one that only an earlier file of the cell had is none of them."""
    places = [_place(row, zones.shape_in_file(cell, zone)) for zone, row in known.items()]
    now = {zone.name for zone in zones.with_zones_as_they_are(cell, known).zones}
    return [place for place in places if place.zone in now or (place.previous or place.in_file) is not None]


def _place(row: ZonePosition, in_file: StandingShape | None) -> ZonePlace:
    return ZonePlace(
        zone=row.zone,
        moves=row.moves,
        moved_by=row.moved_by,
        measured_at=row.measured_at,
        received_at=row.received_at,
        previous=zones.shape_before(row, in_file),
        in_file=in_file,
    )
