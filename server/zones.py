"""Where the protected zones are now: a zone may move with the people in it, and its latest place is kept in the store."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import String, Text, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from core.cell import Cell, Zone
from core.shapes import Pose
from server.errors import Conflict, NotFound
from server.store import Table


class ZonePosition(Table):
    """The latest place of one zone; counts how often it moved."""

    __tablename__ = "zone_positions"

    cell: Mapped[str] = mapped_column(String(64), primary_key=True)
    zone: Mapped[str] = mapped_column(String(64), primary_key=True)
    pose: Mapped[str] = mapped_column(Text)
    moves: Mapped[int]
    measured_at: Mapped[datetime]
    """By the clock of who measured it."""
    received_at: Mapped[datetime]
    moved_by: Mapped[str] = mapped_column(String(80))


def positions(db: Session, cell: str) -> dict[str, ZonePosition]:
    """Of the zones of a cell that have ever moved."""
    return {row.zone: row for row in db.scalars(select(ZonePosition).where(ZonePosition.cell == cell))}


def move(db: Session, cell: Cell, zone: str, pose: Pose, measured_at: datetime, who: str, now: datetime) -> ZonePosition:
    """Keeps a zone's new place.

    Raises:
        NotFound: the cell has no such zone.
        Conflict: a later measurement is known already.
    """
    if zone not in {each.name for each in cell.zones}:
        raise NotFound(f"zone of cell {cell.name!r}", zone)
    row = db.get(ZonePosition, (cell.name, zone))
    if row is not None and measured_at <= row.measured_at:
        raise Conflict(
            f"zone {zone!r}: measured at {measured_at.isoformat()}, but its place at {row.measured_at.isoformat()} is known already; "
            "send measurements in order"
        )
    if row is None:
        row = ZonePosition(cell=cell.name, zone=zone, moves=0)
        db.add(row)
    row.pose, row.moves, row.moved_by = pose.model_dump_json(), row.moves + 1, who
    row.measured_at, row.received_at = measured_at, now
    return row


def with_zones_where_they_are(cell: Cell, known: dict[str, ZonePosition]) -> Cell:
    """The cell with each zone at its latest place; what the place contradicts is not checked (see `core.cell_contradictions`)."""
    zones = tuple(_moved(zone, known[zone.name]) if zone.name in known else zone for zone in cell.zones)
    return cell.model_copy(update={"zones": zones})


def _moved(zone: Zone, position: ZonePosition) -> Zone:
    shape = {**zone.shape.model_dump(), "pose": Pose.model_validate_json(position.pose)}
    return Zone(name=zone.name, shape=type(zone.shape).model_validate(shape))  # made anew: a copy would keep its cached corners
