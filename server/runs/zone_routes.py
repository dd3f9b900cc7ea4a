"""Where the protected zones of a cell are now, where they would be, and the way back."""

from __future__ import annotations

from datetime import datetime, timedelta

from fastapi import APIRouter
from sqlalchemy.orm import Session

from core.payload.shapes import Pose
from core.words.message import Message
from server.cells import zones
from server.cells.folder import CellFolder, CellsDep
from server.cells.now import read_now
from server.cells.zone_check import flaws_of_bodies
from server.cells.zones import ZonePosition
from server.http.dependencies import NamePath, NowDep, StoreDep
from server.http.errors import Conflict
from server.http.flaws import Flaw, list_flaws
from server.http.schemas import Answer, Moment, RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs.conductor import ConductorDep

router = APIRouter(prefix="/api/cells/{cell}/zones", tags=["cells"])

AHEAD = timedelta(seconds=1)  # by how much a measuring clock may go before ours


class ZoneMove(RequestBody):
    """Where a zone's centre was measured, in the world frame; its shape and size stay."""

    pose: Pose
    measured_at: Moment


class ZoneTry(RequestBody):
    """Where a zone's centre would be, in the world frame."""

    pose: Pose


class ZoneBack(RequestBody):
    """The way back.

    Args:
        to: where it was `before`, or where the cell's `file` has it.
        moves: how often the zone had moved when whoever asks saw it; refused where it has moved on since.
    """

    to: zones.Back = "before"
    moves: int | None = None


class ZoneShown(Answer):
    """A zone's latest place.

    Args:
        previous: where it was before that.
        contradiction: why nothing can be planned while it is there; `flaws` says all of it.
    """

    cell: str
    zone: str
    pose: Pose
    previous: Pose
    moves: int
    measured_at: datetime
    received_at: datetime
    contradiction: Message | None
    flaws: list[Flaw]


class ZoneChecked(Answer):
    """Why nothing could be planned with a zone at a place; nothing where `flaws` is empty. The zone has not moved."""

    cell: str
    zone: str
    pose: Pose
    flaws: list[Flaw]


@router.put("/{zone}")
def move_zone(
    cell: NamePath,
    zone: NamePath,
    body: ZoneMove,
    caller: CallerDep,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    now: NowDep,
) -> ZoneShown:
    """Keeps a zone's new place. A place that makes planning impossible is kept too: people are where they are."""
    if body.measured_at > now + AHEAD:
        raise Conflict("zone-clock-ahead", measured_at=body.measured_at.isoformat(), now=now.isoformat())
    loaded = cells.read(cell).cell
    with store.write() as db:
        row = zones.move(db, loaded, zone, body.pose, body.measured_at, caller.who, now)
        said = {"cell": cell, "zone": zone, "pose": row.pose, "measured_at": body.measured_at.isoformat()}
        audit.record(db, caller.who, "zone.move", said, now=now)
        shown = _answer(cells, db, row)
    conductor.tell_zone_move(cell, zone, body.pose)
    return shown


@router.post("/{zone}/check")
def check_zone(cell: NamePath, zone: NamePath, body: ZoneTry, store: StoreDep, cells: CellsDep) -> ZoneChecked:
    """What a zone would contradict at a place, the whole arm at home included, before anybody moves it there."""
    with store.read() as db:
        found = read_now(cells, db, cell)
    zones.place_in_file(found.cell, zone)
    there = zones.with_zones_at(found.cell, {zone: body.pose})
    flaws = cells.flaws(found._replace(cell=there)) or flaws_of_bodies(there)
    return ZoneChecked(cell=cell, zone=zone, pose=body.pose, flaws=list_flaws(flaws))


@router.post("/{zone}/undo")
def put_zone_back(
    cell: NamePath,
    zone: NamePath,
    caller: CallerDep,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    now: NowDep,
    back: ZoneBack | None = None,
) -> ZoneShown:
    """Puts a zone back to where it was before, or to where the cell's file has it; a later measurement moves it as ever."""
    undo = back or ZoneBack()
    loaded = cells.read(cell).cell
    with store.write() as db:
        row = zones.put_back(db, loaded, zone, undo.to, undo.moves, caller.who, now)
        audit.record(db, caller.who, "zone.undo", {"cell": cell, "zone": zone, "to": undo.to, "pose": row.pose}, now=now)
        shown = _answer(cells, db, row)
    conductor.tell_zone_move(cell, zone, shown.pose)
    return shown


def _answer(cells: CellFolder, db: Session, row: ZonePosition) -> ZoneShown:
    flaws = cells.flaws(read_now(cells, db, row.cell))
    return ZoneShown(
        cell=row.cell,
        zone=row.zone,
        pose=Pose.model_validate_json(row.pose),
        previous=zones.before(row, zones.place_in_file(cells.read(row.cell).cell, row.zone)),
        moves=row.moves,
        measured_at=row.measured_at,
        received_at=row.received_at,
        contradiction=flaws[0].message if flaws else None,
        flaws=list_flaws(flaws),
    )
