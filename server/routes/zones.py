"""Where the protected zones of a cell are now."""

from __future__ import annotations

from datetime import datetime, timedelta
from typing import Annotated

from fastapi import APIRouter
from fastapi import Path as InPath

from core.cell_contradictions import contradictions
from core.shapes import Pose
from server import audit, zones
from server.dependencies import Asking, Here, Now
from server.errors import Conflict
from server.schemas import Answer, Body, Moment, Name

router = APIRouter(prefix="/api/cells/{cell}/zones", tags=["cells"])

AHEAD = timedelta(seconds=1)  # by how much a measuring clock may go before ours
PathName = Annotated[Name, InPath()]


class ZoneMove(Body):
    """Where a zone's centre was measured, in the world frame; its shape and size stay."""

    pose: Pose
    measured_at: Moment


class ZoneShown(Answer):
    """A zone's latest place; `contradiction` says why nothing can be planned while it is there."""

    cell: str
    zone: str
    pose: Pose
    moves: int
    measured_at: datetime
    received_at: datetime
    contradiction: str | None


@router.put("/{zone}")
def move_zone(cell: PathName, zone: PathName, moved: ZoneMove, asking: Asking, here: Here, now: Now) -> ZoneShown:
    """Keeps a zone's new place. A place that makes planning impossible is kept too: people are where they are."""
    if moved.measured_at > now + AHEAD:
        raise Conflict(
            f"measured_at: {moved.measured_at.isoformat()} is ahead of the service's clock, {now.isoformat()}; set the measuring clock"
        )
    loaded = here.cells.load(cell)
    with here.store.write() as db:
        row = zones.move(db, loaded, zone, moved.pose, moved.measured_at, asking.who, now)
        said = {"cell": cell, "zone": zone, "pose": row.pose, "measured_at": moved.measured_at.isoformat()}
        audit.record(db, asking.who, "zone.move", said, now=now)
        known = zones.positions(db, cell)
    here.conductor.zone_moved(cell, zone, moved.pose)
    flaw = next(contradictions(zones.with_zones_where_they_are(loaded, known)), None)
    return ZoneShown(
        cell=cell,
        zone=zone,
        pose=moved.pose,
        moves=row.moves,
        measured_at=row.measured_at,
        received_at=row.received_at,
        contradiction=None if flaw is None else f"{flaw.key}: found {flaw.found}, expected {flaw.expected}",
    )
