"""The cells: what there is, whether it can be used, new ones."""

from __future__ import annotations

from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from sqlalchemy.orm import Session

from core.cell.cell import Cell
from core.cell.folder import CellRead
from core.errors import BadInput, BadTwin, HeftError
from core.payload.shapes import Pose
from core.words.message import Message
from server.cells import zones
from server.cells.archive import UPLOAD
from server.cells.folder import CellFolder, CellsDep
from server.cells.now import read_now
from server.cells.uploads import CheckerDep, take_in, upload_folder
from server.cells.zones import ZonePosition
from server.http.dependencies import MetricsDep, NamePath, NowDep, StoreDep
from server.http.flaws import Flaw, list_flaws
from server.http.schemas import Answer
from server.http.zip_body import ZIP, check_is_zip, write_body
from server.people import audit
from server.people.auth import CallerDep

router = APIRouter(prefix="/api/cells", tags=["cells"])


class CellListed(Answer):
    """A cell; `flaw` says why nothing can be planned in it now, `flaws` says all of it."""

    name: str
    title: str | None
    flaw: Message | None
    flaws: list[Flaw]


class ZonePlace(Answer):
    """When a zone was brought to where it is now, and by whom: measured by the clock of who measured it, received by ours.

    Args:
        previous: where it was before.
        in_file: where the cell's file has it.
    """

    zone: str
    moves: int
    moved_by: str
    measured_at: datetime
    received_at: datetime
    previous: Pose
    in_file: Pose


class CellShown(Answer):
    """A cell, its protected zones where they are now; `sha256` covers its files.

    Args:
        cell: null where its `cell.toml` cannot be read as a cell; then `flaws` says why.
        flaws: why nothing can be planned in it now, be it the fault of its files or of where its zones are.
        in_the_way: obstacles and zones that stand where the robot's base is.
        drawn: whether `/viewer/{cell}/` can show it, which takes a sound robot.
        moved: the zones that were brought to where they are now.
        read_at: the service's clock, for who measures zones and has none of their own that agrees.
    """

    cell: Cell | None
    flaws: list[Flaw]
    in_the_way: list[str]
    drawn: bool
    sha256: str
    moved: list[ZonePlace]
    read_at: datetime


class CellTaken(Answer):
    """A cell that was checked, and where there is one, put into its place."""

    name: str
    sha256: str | None


async def _receive_upload(request: Request, cells: CellsDep) -> AsyncIterator[Path]:
    """The folder with the request's body in it, while the request lasts."""
    check_is_zip(request, "cell")
    with upload_folder(cells) as folder:
        await write_body(request, folder / UPLOAD)
        yield folder


UploadDep = Annotated[Path, Depends(_receive_upload)]


@router.get("")
def list_cells(cells: CellsDep, store: StoreDep) -> list[CellListed]:
    """All cells, also those in which nothing can be planned."""
    with store.read() as db:
        return [_summarise(name, *_inspect(cells, db, name)) for name in cells.names()]


@router.get("/{cell}")
def read_cell(cell: NamePath, cells: CellsDep, store: StoreDep, now: NowDep) -> CellShown:
    """A cell, its protected zones where they are now, and what speaks against planning in it."""
    with store.read() as db:
        cell_read, flaws = _inspect(cells, db, cell)
        known = zones.positions(db, cell)
    in_file = {} if cell_read is None else {each.name: each.shape.pose for each in cells.read(cell).cell.zones}
    return CellShown(
        cell=None if cell_read is None else cell_read.cell,
        flaws=list_flaws(flaws),
        in_the_way=[flaw.in_the_way for flaw in flaws if flaw.in_the_way is not None],
        drawn=cell_read is not None and not cell_read.robot_flaws,
        sha256=cells.digest(cell),
        moved=[_place(row, in_file[zone]) for zone, row in known.items() if zone in in_file],
        read_at=now,
    )


@router.post("/validate", openapi_extra=ZIP)
def validate_cell(folder: UploadDep, checker: CheckerDep) -> CellTaken:
    """Checks a zip of a cell and keeps nothing."""
    name = checker.check(folder)
    return CellTaken(name=name, sha256=None)


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
) -> CellTaken:
    """Takes a new cell in."""
    taken = _take_in(store, cells, metrics, checker, folder, None, caller, now)
    response.headers["Location"] = f"/api/cells/{taken.name}"
    return taken


@router.put("/{cell}", openapi_extra=ZIP)
def replace_cell(
    cell: NamePath,
    folder: UploadDep,
    store: StoreDep,
    cells: CellsDep,
    metrics: MetricsDep,
    checker: CheckerDep,
    caller: CallerDep,
    now: NowDep,
) -> CellTaken:
    """Takes a cell in, in place of the one of that name."""
    return _take_in(store, cells, metrics, checker, folder, cell, caller, now)


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


def _summarise(name: str, cell_read: CellRead | None, flaws: list[BadInput]) -> CellListed:
    title = None if cell_read is None else cell_read.cell.title
    return CellListed(name=name, title=title, flaw=flaws[0].message if flaws else None, flaws=list_flaws(flaws))


def _place(row: ZonePosition, in_file: Pose) -> ZonePlace:
    return ZonePlace(
        zone=row.zone,
        moves=row.moves,
        moved_by=row.moved_by,
        measured_at=row.measured_at,
        received_at=row.received_at,
        previous=zones.before(row, in_file),
        in_file=in_file,
    )


def _take_in(
    store: StoreDep,
    cells: CellsDep,
    metrics: MetricsDep,
    checker: CheckerDep,
    folder: Path,
    name: str | None,
    caller: CallerDep,
    now: NowDep,
) -> CellTaken:
    counted = metrics.cells_checked.labels
    try:
        found = take_in(checker, cells, folder, name=name)
    except HeftError:
        counted("refused").inc()
        raise
    counted("taken in").inc()
    sha256 = cells.digest(found)
    with store.write() as db:
        audit.record(db, caller.who, "cell.create" if name is None else "cell.replace", {"cell": found, "sha256": sha256}, now=now)
    return CellTaken(name=found, sha256=sha256)
