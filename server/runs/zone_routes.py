"""Where the protected zones of a cell are now, where they would be, and the way back."""

from __future__ import annotations

from datetime import datetime, timedelta

from fastapi import APIRouter
from pydantic import Field
from sqlalchemy.orm import Session

from core.payload.shapes import Pose
from core.words.message import Message
from server.cells import zones
from server.cells.folder import CellFolder, CellsDep
from server.cells.now import read_now
from server.cells.zone_check import flaws_of_bodies
from server.cells.zones import ZonePosition
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Conflict
from server.http.flaws import Flaw, list_flaws
from server.http.parameters import CellPath, ZonePath
from server.http.schemas import Answer, Moment, RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs.conductor import ConductorDep

router = APIRouter(prefix="/api/cells/{cell}/zones", tags=["cells"])

AHEAD = timedelta(seconds=1)  # by how much a measuring clock may go before ours


class ZoneUpdate(RequestBody):
    """Where a zone's centre was measured, in the world frame; its shape and size stay."""

    pose: Pose = Field(description="Where its centre was measured, world frame; shape and size stay.")
    measured_at: Moment = Field(
        description="When, ISO 8601 with its offset from UTC; what is older than the latest known is refused.",
        examples=["2026-03-01T08:00:00Z"],
    )


class ZoneCheckCreate(RequestBody):
    """Where a zone's centre would be, in the world frame."""

    pose: Pose = Field(description="Where its centre would be, world frame.")


class ZoneUndoCreate(RequestBody):
    """The way back."""

    to: zones.Back = Field(default="before", description="To where it was before, or to where the cell's file has it.")
    moves: int | None = Field(
        default=None,
        description="How often it had moved when whoever asks saw it; refused where it has moved on since. Not compared where null.",
        examples=[3],
    )


class ZonePublic(Answer):
    """A zone's latest place."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    zone: str = Field(description="Name of the zone.", examples=["operator"])
    pose: Pose = Field(description="Where its centre is, world frame.")
    previous: Pose = Field(description="Where it was before that.")
    moves: int = Field(description="How often it has moved.", examples=[3])
    measured_at: datetime = Field(description="When it was measured, by the clock of who did.", examples=["2026-03-01T08:00:00Z"])
    received_at: datetime = Field(description="When the service heard of it, by its own clock.", examples=["2026-03-01T08:00:00.120Z"])
    contradiction: Message | None = Field(description="Why nothing can be planned while it is there; null where something can.")
    flaws: list[Flaw] = Field(description="All that speaks against planning while it is there.")


class ZoneCheckPublic(Answer):
    """Why nothing could be planned with a zone at a place; nothing where `flaws` is empty. The zone has not moved."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    zone: str = Field(description="Name of the zone.", examples=["operator"])
    pose: Pose = Field(description="Where its centre would be, world frame.")
    flaws: list[Flaw] = Field(description="Why nothing could be planned with it there; empty where something could. It has not moved.")


@router.put("/{zone}")
def move_zone(
    cell: CellPath,
    zone: ZonePath,
    body: ZoneUpdate,
    caller: CallerDep,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    now: NowDep,
) -> ZonePublic:
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
def check_zone(cell: CellPath, zone: ZonePath, body: ZoneCheckCreate, store: StoreDep, cells: CellsDep) -> ZoneCheckPublic:
    """What a zone would contradict at a place, the whole arm at home included, before anybody moves it there."""
    with store.read() as db:
        found = read_now(cells, db, cell)
    zones.place_in_file(found.cell, zone)
    there = zones.with_zones_at(found.cell, {zone: body.pose})
    flaws = cells.flaws(found._replace(cell=there)) or flaws_of_bodies(there)
    return ZoneCheckPublic(cell=cell, zone=zone, pose=body.pose, flaws=list_flaws(flaws))


@router.post("/{zone}/undo")
def put_zone_back(
    cell: CellPath,
    zone: ZonePath,
    caller: CallerDep,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    now: NowDep,
    back: ZoneUndoCreate | None = None,
) -> ZonePublic:
    """Puts a zone back to where it was before, or to where the cell's file has it; a later measurement moves it as ever."""
    undo = back or ZoneUndoCreate()
    loaded = cells.read(cell).cell
    with store.write() as db:
        row = zones.put_back(db, loaded, zone, undo.to, undo.moves, caller.who, now)
        audit.record(db, caller.who, "zone.undo", {"cell": cell, "zone": zone, "to": undo.to, "pose": row.pose}, now=now)
        shown = _answer(cells, db, row)
    conductor.tell_zone_move(cell, zone, shown.pose)
    return shown


def _answer(cells: CellFolder, db: Session, row: ZonePosition) -> ZonePublic:
    flaws = cells.flaws(read_now(cells, db, row.cell))
    return ZonePublic(
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
