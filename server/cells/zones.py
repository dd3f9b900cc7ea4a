"""Where the protected zones are now: a zone may move with the people in it, and its latest place is kept in the store."""

from __future__ import annotations

from datetime import datetime
from typing import Literal

from sqlalchemy import String, Text, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from core.cell.cell import Cell, Zone
from core.payload.shapes import Pose
from server.http.errors import Conflict, NotFound
from server.store.store import Table

Back = Literal["before", "file"]
"""To where a zone was before, or to where the cell's file has it."""


class ZonePosition(Table):
    """The latest place of one zone and the one before it; counts how often it moved."""

    __tablename__ = "zone_positions"

    cell: Mapped[str] = mapped_column(String(64), primary_key=True)
    zone: Mapped[str] = mapped_column(String(64), primary_key=True)
    pose: Mapped[str] = mapped_column(Text)
    previous: Mapped[str | None] = mapped_column(Text)
    """None: where the cell's file has it."""
    moves: Mapped[int]
    measured_at: Mapped[datetime]
    """When it was last measured, by the clock of who did; a zone that was put back has not been measured again."""
    received_at: Mapped[datetime]
    moved_by: Mapped[str] = mapped_column(String(80))


def positions(db: Session, cell: str) -> dict[str, ZonePosition]:
    """Of the zones of a cell that have ever moved."""
    return {row.zone: row for row in db.scalars(select(ZonePosition).where(ZonePosition.cell == cell))}


def place_in_file(cell: Cell, zone: str) -> Pose:
    """Where the cell's file has a zone.

    Raises:
        NotFound: the cell has no such zone.
    """
    for each in cell.zones:
        if each.name == zone:
            return each.shape.pose
    raise NotFound("zone-unknown", cell=cell.name, zone=zone[:80])


def move(db: Session, cell: Cell, zone: str, pose: Pose, measured_at: datetime, who: str, now: datetime) -> ZonePosition:
    """Keeps a zone's new place.

    Raises:
        NotFound: the cell has no such zone.
        Conflict: a later measurement is known already.
    """
    place_in_file(cell, zone)
    row = db.get(ZonePosition, (cell.name, zone))
    if row is not None and measured_at <= row.measured_at:
        raise Conflict("zone-measured-before", zone=zone, measured_at=measured_at.isoformat(), known_at=row.measured_at.isoformat())
    if row is None:
        row = ZonePosition(cell=cell.name, zone=zone, pose=place_in_file(cell, zone).model_dump_json(), moves=0)
        db.add(row)
    row.measured_at = measured_at
    _put(row, pose, who, now)
    return row


def put_back(db: Session, cell: Cell, zone: str, to: Back, moves: int | None, who: str, now: datetime) -> ZonePosition:
    """Puts a zone back; putting it back twice to where it was before takes the first back.

    Args:
        moves: how often it had moved when somebody saw where it was; None where nobody says.

    Raises:
        NotFound: the cell has no such zone.
        Conflict: it has not moved, or has moved on since.
    """
    in_file = place_in_file(cell, zone)
    row = db.get(ZonePosition, (cell.name, zone))
    if row is None:
        raise Conflict("zone-not-moved", zone=zone)
    if moves is not None and moves != row.moves:
        raise Conflict("zone-moved-on", zone=zone, moves=row.moves, seen_moves=moves)
    _put(row, in_file if to == "file" else before(row, in_file), who, now)
    return row


def before(row: ZonePosition, in_file: Pose) -> Pose:
    """Where the zone was before it came to where it is now."""
    return in_file if row.previous is None else Pose.model_validate_json(row.previous)


def _put(row: ZonePosition, pose: Pose, who: str, now: datetime) -> None:
    there = pose.model_dump_json()
    if there != row.pose:  # a tracker that sees somebody stand still does not make the place before forgotten
        row.previous, row.pose = row.pose, there
    row.moves, row.moved_by, row.received_at = row.moves + 1, who, now


def with_zones_where_they_are(cell: Cell, rows: dict[str, ZonePosition]) -> Cell:
    """The cell with each zone at its latest place; what the place contradicts says `core.cell.folder.contradictions_of`."""
    places = {zone: Pose.model_validate_json(row.pose) for zone, row in rows.items()}
    return with_zones_at(cell, places)


def with_zones_at(cell: Cell, places: dict[str, Pose]) -> Cell:
    """The cell with some zones elsewhere."""
    zones = tuple(_with_pose(zone, places[zone.name]) if zone.name in places else zone for zone in cell.zones)
    return cell.model_copy(update={"zones": zones})


def _with_pose(zone: Zone, pose: Pose) -> Zone:
    shape = {**zone.shape.model_dump(), "pose": pose}
    return Zone(name=zone.name, shape=type(zone.shape).model_validate(shape))  # made anew: a copy would keep its cached corners
