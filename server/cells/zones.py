"""How the protected zones are now: they move with the people in them, are drawn, resized and removed; the latest stands in the store."""

from __future__ import annotations

import json
from datetime import datetime
from typing import Literal

from pydantic import TypeAdapter
from sqlalchemy import String, Text, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from core.cell.cell import Cell
from core.payload.shapes import Pose, Shape, StandingShape
from server.http.errors import Conflict, NotFound
from server.store.store import Table

Back = Literal["before", "file"]
"""To how a zone was before, or to how the cell's file has it."""
SHAPES: TypeAdapter[StandingShape] = TypeAdapter(StandingShape)
GONE = "null"


class ZonePosition(Table):
    """One zone as it is now and as it was before; counts how often it changed."""

    __tablename__ = "zone_positions"

    cell: Mapped[str] = mapped_column(String(64), primary_key=True)
    zone: Mapped[str] = mapped_column(String(64), primary_key=True)
    place: Mapped[str] = mapped_column("pose", Text)
    """JSON: a pose where it has only moved, its whole shape where that was drawn here, null where it was removed."""
    previous: Mapped[str | None] = mapped_column(Text)
    """The same of before; None: as the cell's file has it."""
    moves: Mapped[int]
    measured_at: Mapped[datetime]
    """When it was last measured, by the clock of who did; a zone that was put back has not been measured again."""
    received_at: Mapped[datetime]
    moved_by: Mapped[str] = mapped_column(String(80))


def positions(db: Session, cell: str) -> dict[str, ZonePosition]:
    """Of the zones of a cell that have ever changed."""
    return {row.zone: row for row in db.scalars(select(ZonePosition).where(ZonePosition.cell == cell).order_by(ZonePosition.zone))}


def shape_in_file(cell: Cell, zone: str) -> StandingShape | None:
    """How the cell's file has a zone; None where it has none of that name."""
    return next((each.shape for each in cell.zones if each.name == zone), None)


def shape_now(row: ZonePosition, in_file: StandingShape | None) -> StandingShape | None:
    """How the zone is now; None where there is none."""
    return _shape_of(row.place, in_file)


def shape_before(row: ZonePosition, in_file: StandingShape | None) -> StandingShape | None:
    """How the zone was before it became what it is now; None where there was none."""
    return _shape_of(row.previous, in_file)


def find(db: Session, cell: Cell, zone: str) -> tuple[ZonePosition | None, StandingShape]:
    """What is kept of a zone, and how it is now.

    Args:
        cell: as its file has it.

    Raises:
        NotFound: the cell has no such zone.
    """
    row, in_file = db.get(ZonePosition, (cell.name, zone)), shape_in_file(cell, zone)
    now = in_file if row is None else shape_now(row, in_file)
    if now is None:
        raise NotFound("zone-unknown", cell=cell.name, zone=zone[:80])
    return row, now


def move(db: Session, cell: Cell, zone: str, pose: Pose, measured_at: datetime, who: str, now: datetime) -> ZonePosition:
    """Keeps a zone's new place.

    Raises:
        NotFound: the cell has no such zone.
        Conflict: a later measurement is known already.
    """
    row, shape = find(db, cell, zone)
    if row is not None and measured_at <= row.measured_at:
        raise Conflict("zone-measured-before", zone=zone, measured_at=measured_at.isoformat(), known_at=row.measured_at.isoformat())
    follows_file = row is None or "kind" not in (json.loads(row.place) or {})
    place = pose.model_dump_json() if follows_file else _with_pose(shape, pose).model_dump_json()
    return _put(db, row or _row(cell.name, zone), place, who, now, measured_at)


def create(db: Session, cell: Cell, zone: str, shape: Shape, who: str, now: datetime) -> ZonePosition:
    """Keeps a new zone.

    Raises:
        Conflict: there is one of that name by now.
    """
    row, in_file = db.get(ZonePosition, (cell.name, zone)), shape_in_file(cell, zone)
    if (in_file if row is None else shape_now(row, in_file)) is not None:
        raise Conflict("zone-exists", zone=zone)
    return _put(db, row or _row(cell.name, zone), shape.model_dump_json(), who, now, now)


def reshape(db: Session, cell: Cell, zone: str, shape: Shape, who: str, now: datetime) -> ZonePosition:
    """Keeps a zone's new size and place.

    Raises:
        NotFound: the cell has no such zone.
    """
    row, _ = find(db, cell, zone)
    return _put(db, row or _row(cell.name, zone), shape.model_dump_json(), who, now, now)


def take_out(db: Session, cell: Cell, zone: str, who: str, now: datetime) -> ZonePosition:
    """Takes a zone out of the cell; it can be put back.

    Raises:
        NotFound: the cell has no such zone.
    """
    row, _ = find(db, cell, zone)
    return _put(db, row or _row(cell.name, zone), GONE, who, now, now)


def put_back(db: Session, cell: Cell, zone: str, to: Back, moves: int | None, who: str, now: datetime) -> ZonePosition:
    """Puts a zone back; putting it back twice to how it was before takes the first back.

    Args:
        moves: how often it had changed when somebody saw how it was; None where nobody says.

    Raises:
        NotFound: the cell has no such zone, and never had.
        Conflict: it has not changed, or has changed again since.
    """
    row, in_file = db.get(ZonePosition, (cell.name, zone)), shape_in_file(cell, zone)
    if row is None:
        if in_file is None:
            raise NotFound("zone-unknown", cell=cell.name, zone=zone[:80])
        raise Conflict("zone-not-moved", zone=zone)
    if moves is not None and moves != row.moves:
        raise Conflict("zone-moved-on", zone=zone, moves=row.moves, seen_moves=moves)
    back = in_file if to == "file" else shape_before(row, in_file)
    kept = row.previous if to == "before" and row.previous is not None else _dump(back, in_file)
    return _put(db, row, kept, who, now, row.measured_at)


def _row(cell: str, zone: str) -> ZonePosition:
    return ZonePosition(cell=cell, zone=zone, moves=0)


def _put(db: Session, row: ZonePosition, place: str, who: str, now: datetime, measured_at: datetime) -> ZonePosition:
    if place != row.place:  # a tracker that sees somebody stand still does not make the place before forgotten
        row.previous, row.place = row.place, place
    row.moves, row.moved_by, row.received_at, row.measured_at = row.moves + 1, who, now, measured_at
    db.add(row)
    return row


def _dump(shape: StandingShape | None, in_file: StandingShape | None) -> str:
    """A shape as it is kept; of one that is the file's, only where it is: a corrected file corrects it too."""
    if shape is None:
        return GONE
    return shape.pose.model_dump_json() if shape == in_file else shape.model_dump_json()


def _shape_of(kept: str | None, in_file: StandingShape | None) -> StandingShape | None:
    place = None if kept is None else json.loads(kept)
    if kept is None:
        return in_file
    if place is None:
        return None
    if "kind" in place:
        return SHAPES.validate_python(place, strict=False)
    return None if in_file is None else _with_pose(in_file, Pose.model_validate(place))


def with_zones_as_they_are(cell: Cell, rows: dict[str, ZonePosition]) -> Cell:
    """The cell with its zones as they are now; what they contradict says `core.cell.folder.contradictions_of`."""
    now = cell
    for zone, row in rows.items():
        now = now.with_zone(zone, shape_now(row, shape_in_file(cell, zone)))
    return now


def _with_pose(shape: StandingShape, pose: Pose) -> StandingShape:
    return type(shape).model_validate({**shape.model_dump(), "pose": pose})  # made anew: a copy would keep its cached corners
