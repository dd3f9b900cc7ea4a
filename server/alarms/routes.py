"""Alarms: what needs a person now, acknowledged by whom, and what there was."""

from __future__ import annotations

import asyncio
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Query, WebSocket
from pydantic import Field
from sqlalchemy import select

from core.words.message import Message
from server.alarms.kinds import KINDS, Severity
from server.alarms.tables import AlarmRow
from server.alarms.watch import AlarmsDep
from server.http.asyncapi import SocketDescription
from server.http.dependencies import NowDep, StoreDep, get_now
from server.http.parameters import AlarmPath, LimitQuery
from server.http.schemas import Answer
from server.http.telling import keep_telling
from server.people import audit
from server.people.auth import CallerDep

router = APIRouter(prefix="/api/alarms", tags=["alarms"])

PULSE_S = 1.0


class AlarmPublic(Answer):
    """An alarm: open while what it tells of lasts and, where it stays, until somebody has acknowledged it."""

    id: str = Field(description="Sorts by time.", examples=["019a0f3c52b1c4f0a1b2c3"])
    kind: str = Field(description="Which situation, see docs/alarms.md.", examples=["run_aborted"])
    severity: Severity = Field(description="A person is needed now (high), soon (medium), or when there is time (low).", examples=["high"])
    stays: bool = Field(description="Whether it is open until it is acknowledged, also when what it tells of is over.", examples=[True])
    cell: str | None = Field(description="The cell that it is about; null where it is about the service.", examples=["lwr4_bench"])
    run: str | None = Field(description="The run that it is about, or null.", examples=["019a0f3c52b1c4f0a1b2c3"])
    message: Message = Field(description="What there is to say.")
    advice: Message = Field(description="What to do.")
    raised_at: datetime = Field(description="Since when; ISO 8601 with offset.", examples=["2026-11-23T08:15:00Z"])
    cleared_at: datetime | None = Field(description="When that was over; null while it lasts.", examples=["2026-11-23T08:20:00Z"])
    acknowledged_by: str | None = Field(description="Who has seen it; null where nobody has.", examples=["account:anna"])
    acknowledged_at: datetime | None = Field(description="When they did; ISO 8601.", examples=["2026-11-23T08:16:00Z"])


class AlarmsLive(Answer):
    """What the websocket sends: at once, with every change, and each second a sign of life."""

    at: datetime = Field(description="The service's time.", examples=["2026-03-01T08:00:00.120Z"])
    alarms: list[AlarmPublic] | None = Field(description="All that are open, newest first; null where nothing has changed.")


SOCKETS = (
    SocketDescription(
        "/api/alarms/live",
        "Every open alarm: at once, as they come and go, and each second, so that silence means a lost connection.",
        sends=(AlarmsLive,),
    ),
)


@router.get("")
def list_alarms(
    store: StoreDep,
    cell: Annotated[str | None, Query(description="Of this cell alone.", examples=["lwr4_bench"])] = None,
    before: Annotated[
        str | None, Query(description="Older than this alarm: the last of a list gives the next one.", examples=["019a0f3c52b1c4f0a1b2c3"])
    ] = None,
    limit: LimitQuery = 50,
) -> list[AlarmPublic]:
    """The history, newest first, open ones included."""
    query = select(AlarmRow).order_by(AlarmRow.id.desc()).limit(limit)
    query = query if cell is None else query.where(AlarmRow.cell == cell)
    query = query if before is None else query.where(AlarmRow.id < before)
    with store.read() as db:
        return [_answer(row) for row in db.scalars(query)]


@router.get("/open")
async def list_open_alarms(alarms: AlarmsDep) -> list[AlarmPublic]:
    """Those that need somebody, newest first; told from memory."""
    return [_answer(row) for row in alarms.book.open]


@router.post("/{alarm}/acknowledgement")
async def acknowledge_alarm(alarm: AlarmPath, alarms: AlarmsDep, store: StoreDep, caller: CallerDep, now: NowDep) -> AlarmPublic:
    """Somebody has seen it and takes care of it."""
    row = alarms.book.check_acknowledgeable(alarm)
    detail = {"alarm": row.id, "kind": row.kind, "cell": row.cell, "run": row.run}

    def write() -> None:
        with store.write() as db:
            audit.record(db, caller.who, "alarm.acknowledge", detail, now=now)

    await asyncio.to_thread(write)
    return _answer(alarms.book.acknowledge(alarm, caller.who, now))


@router.websocket("/live")
async def watch_alarms(websocket: WebSocket, alarms: AlarmsDep) -> None:
    """Every open alarm, as they come and go."""

    async def word(_changes: int, changed: bool) -> AlarmsLive:
        return AlarmsLive(at=get_now(websocket), alarms=[_answer(row) for row in alarms.book.open] if changed else None)

    await keep_telling(websocket, lambda: alarms.book.changes, word, PULSE_S)


def _answer(row: AlarmRow) -> AlarmPublic:
    kind = KINDS[row.kind]
    return AlarmPublic(
        id=row.id,
        kind=row.kind,
        severity=kind.severity,
        stays=kind.stays,
        cell=row.cell,
        run=row.run,
        message=Message.model_validate_json(row.message),
        advice=Message.of(kind.advice),
        raised_at=row.raised_at,
        cleared_at=row.cleared_at,
        acknowledged_by=row.acknowledged_by,
        acknowledged_at=row.acknowledged_at,
    )
