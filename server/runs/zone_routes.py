"""The protected zones of a cell as they are now: moved, drawn, resized, removed, what that would mean, and the way back."""

from __future__ import annotations

from datetime import datetime, timedelta

from fastapi import APIRouter, Response
from pydantic import Field
from sqlalchemy.orm import Session

from core.errors import BadInput, BadZone, refuse
from core.payload.shapes import Pose, Shape, StandingShape
from core.words.message import Message
from server.cells import zones
from server.cells.folder import CellFolder, CellsDep
from server.cells.now import read_now
from server.cells.payloads import list_saved
from server.cells.zone_check import drawing_flaws
from server.cells.zones import ZonePosition
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Conflict
from server.http.flaws import Flaw, list_flaws, restore_flaw
from server.http.parameters import CellPath, ZonePath
from server.http.schemas import Answer, AnyShape, Moment, Name, RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs.conductor import ConductorDep
from server.store.store import Store

router = APIRouter(prefix="/api/cells/{cell}/zones", tags=["cells"])

AHEAD = timedelta(seconds=1)  # by how much a measuring clock may go before ours


class ZoneUpdate(RequestBody):
    """Where a zone's centre was measured, in the world frame; its shape and size stay."""

    pose: Pose = Field(description="Where its centre was measured, world frame; shape and size stay.")
    measured_at: Moment = Field(
        description="When, ISO 8601 with its offset from UTC; what is older than the latest known is refused.",
        examples=["2026-03-01T08:00:00Z"],
    )


class ZoneCreate(RequestBody):
    """A new zone."""

    name: Name = Field(description="Its name: no other zone, obstacle, tool, payload or link of the robot has it.", examples=["trolley"])
    shape: AnyShape = Field(description="Its shape, size and place, world frame.")


class ZoneShapeUpdate(RequestBody):
    """A zone as it is from now on."""

    shape: AnyShape = Field(description="Its shape, size and place, world frame.")


class ZoneCheckCreate(RequestBody):
    """A zone as it would be."""

    shape: AnyShape = Field(description="Its shape, size and place, world frame.")
    new: bool = Field(default=False, description="Whether it is a new one, whose name has to be free.", examples=[False])


class ZoneUndoCreate(RequestBody):
    """The way back."""

    to: zones.Back = Field(default="before", description="To how it was before, or to how the cell's file has it.")
    moves: int | None = Field(
        default=None,
        description="How often it had changed when whoever asks saw it; refused where it has changed since. Not compared where null.",
        examples=[3],
    )


class ZonePublic(Answer):
    """A zone as it is now."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    zone: str = Field(description="Name of the zone.", examples=["operator"])
    shape: StandingShape | None = Field(description="Its shape, size and place, world frame; null where it was removed.")
    previous: StandingShape | None = Field(description="The same before that; null where there was none.")
    moves: int = Field(description="How often it has changed.", examples=[3])
    measured_at: datetime = Field(description="When it was measured, by the clock of who did.", examples=["2026-03-01T08:00:00Z"])
    received_at: datetime = Field(description="When the service heard of it, by its own clock.", examples=["2026-03-01T08:00:00.120Z"])
    contradiction: Message | None = Field(description="Why nothing can be planned while it is there; null where something can.")
    flaws: list[Flaw] = Field(description="All that speaks against planning while it is there.")


class ZoneCheckPublic(Answer):
    """What speaks against a zone as it would be; nothing where `flaws` is empty. It has not changed."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    zone: str = Field(description="Name of the zone.", examples=["operator"])
    shape: Shape = Field(description="Its shape, size and place as asked, world frame.")
    flaws: list[Flaw] = Field(
        description="What would keep the robot from being planned for, or the zone from being drawn; empty where nothing would."
    )


@router.post("", status_code=201)
def create_zone(
    cell: CellPath,
    body: ZoneCreate,
    caller: CallerDep,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    now: NowDep,
    response: Response,
) -> ZonePublic:
    """Adds a zone that somebody draws: its name has to be free, its size sensible, and the robot at home outside of it."""
    _refuse_drawing(cells, store, cell, body.name, body.shape, is_new=True)
    shown = _draw(cells, store, cell, body.name, body.shape, caller.who, now, is_new=True)
    conductor.tell_zone_change(cell, body.name, shown.shape)
    response.headers["Location"] = f"/api/cells/{cell}"
    return shown


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
        pose = body.pose.model_dump_json()
        said = {"cell": cell, "zone": zone, "pose": pose, "measured_at": body.measured_at.isoformat()}
        audit.record(db, caller.who, "zone.move", said, now=now)
        shown = _answer(cells, db, row)
    conductor.tell_zone_change(cell, zone, shown.shape)
    return shown


@router.put("/{zone}/shape")
def reshape_zone(
    cell: CellPath,
    zone: ZonePath,
    body: ZoneShapeUpdate,
    caller: CallerDep,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    now: NowDep,
) -> ZonePublic:
    """Gives a zone another size and place: the size has to be sensible, and the robot at home outside of it."""
    _refuse_drawing(cells, store, cell, zone, body.shape, is_new=False)
    shown = _draw(cells, store, cell, zone, body.shape, caller.who, now, is_new=False)
    conductor.tell_zone_change(cell, zone, shown.shape)
    return shown


@router.delete("/{zone}")
def delete_zone(
    cell: CellPath, zone: ZonePath, caller: CallerDep, store: StoreDep, cells: CellsDep, conductor: ConductorDep, now: NowDep
) -> ZonePublic:
    """Takes a zone out of the cell; `undo` puts it back."""
    loaded = cells.read(cell).cell
    with store.write() as db:
        row = zones.take_out(db, loaded, zone, caller.who, now)
        audit.record(db, caller.who, "zone.delete", {"cell": cell, "zone": zone}, now=now)
        shown = _answer(cells, db, row)
    conductor.tell_zone_change(cell, zone, None)
    return shown


@router.post("/{zone}/check")
def check_zone(cell: CellPath, zone: ZonePath, body: ZoneCheckCreate, store: StoreDep, cells: CellsDep) -> ZoneCheckPublic:
    """What a zone would contradict, the whole arm at home included, before anybody moves it there or draws it so."""
    flaws = _find_flaws(cells, store, cell, zone, body.shape, is_new=body.new)
    return ZoneCheckPublic(cell=cell, zone=zone, shape=body.shape, flaws=list_flaws(flaws))


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
    """Puts a zone back to how it was before, or to how the cell's file has it; a later measurement moves it as ever."""
    undo = back or ZoneUndoCreate()
    loaded = cells.read(cell).cell
    with store.write() as db:
        row = zones.put_back(db, loaded, zone, undo.to, undo.moves, caller.who, now)
        audit.record(db, caller.who, "zone.undo", {"cell": cell, "zone": zone, "to": undo.to, "place": row.place}, now=now)
        shown = _answer(cells, db, row)
    conductor.tell_zone_change(cell, zone, shown.shape)
    return shown


def _find_flaws(cells: CellFolder, store: Store, cell: str, zone: str, shape: Shape, *, is_new: bool) -> list[BadInput]:
    """What speaks against a zone as it would be.

    Raises:
        NotFound: there is no such cell; no such zone, where it is not a new one.
        BadRobot: the robot cannot be used: nobody can say where its arm is.
    """
    with store.read() as db:
        found = read_now(cells, db, cell)
        saved = [each.name for each in list_saved(db, cell)]
        if not is_new:
            zones.find(db, cells.read(cell).cell, zone)
    if found.robot_flaws:
        refuse(cells.flaws(found))
    return [cells.shorten_paths(each) for each in drawing_flaws(found.cell, zone, shape, is_new=is_new, saved=saved)]


def _refuse_drawing(cells: CellFolder, store: Store, cell: str, zone: str, shape: Shape, *, is_new: bool) -> None:
    """Refuses what speaks against this zone; what another one contradicts already is no fault of it.

    Raises:
        BadZone: its name, its size, or the robot in it.
    """
    flaws = _find_flaws(cells, store, cell, zone, shape, is_new=is_new)
    refuse([restore_flaw(BadZone, flaw.message) for flaw in flaws if flaw.in_the_way in (None, zone)])


def _draw(cells: CellFolder, store: Store, cell: str, zone: str, shape: Shape, who: str, now: datetime, *, is_new: bool) -> ZonePublic:
    loaded = cells.read(cell).cell
    with store.write() as db:
        row = (zones.create if is_new else zones.reshape)(db, loaded, zone, shape, who, now)
        action = "zone.create" if is_new else "zone.reshape"
        audit.record(db, who, action, {"cell": cell, "zone": zone, "shape": shape.model_dump_json()}, now=now)
        return _answer(cells, db, row)


def _answer(cells: CellFolder, db: Session, row: ZonePosition) -> ZonePublic:
    flaws = cells.flaws(read_now(cells, db, row.cell))
    in_file = zones.shape_in_file(cells.read(row.cell).cell, row.zone)
    return ZonePublic(
        cell=row.cell,
        zone=row.zone,
        shape=zones.shape_now(row, in_file),
        previous=zones.shape_before(row, in_file),
        moves=row.moves,
        measured_at=row.measured_at,
        received_at=row.received_at,
        contradiction=flaws[0].message if flaws else None,
        flaws=list_flaws(flaws),
    )
