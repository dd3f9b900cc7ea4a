"""What a console follows without asking again: every robot that a run has, and the run and the control of one cell.

Both websockets say everything at once, then what has changed, and the same again after a while: who hears nothing for longer has lost
the connection. Nothing here waits for the database.
"""

from __future__ import annotations

import asyncio
from datetime import datetime

from fastapi import APIRouter, WebSocket
from pydantic import Field

from server.cells.folder import CellsDep
from server.http.asyncapi import SocketDescription
from server.http.dependencies import get_now
from server.http.errors import NotFound
from server.http.schemas import Answer
from server.http.telling import keep_telling
from server.runs.answer import answer_now
from server.runs.conductor import ConductorDep
from server.runs.control_answer import ControlPublic, answer_control, control_settings
from server.runs.lease import ControlDep, ControlRegistry
from server.runs.now_routes import CellNow, cell_now
from server.runs.schemas import RunPublic

router = APIRouter(tags=["now"])

PULSE_S = 0.5
"""After so long the same is said again: often enough that a lost connection is noticed within some 1.5 s."""
FIGURES_S = 1.0
"""How often what changes all the time is said anew: progress, and the figures of the link."""
POLICY_VIOLATION = 1008


class RobotsNow(Answer):
    """Every cell with a robot that a run has; `at` is the service's time."""

    at: datetime = Field(description="The service's time.", examples=["2026-03-01T08:00:00.120Z"])
    robots: list[CellNow] = Field(description="Every cell with a robot that a run has.")


class CellLive(Answer):
    """The run that has a cell, null where none has, and who is in control of it."""

    run: RunPublic | None = Field(description="The run that has the cell; null where none does.")
    control: ControlPublic = Field(description="Who is in control of it.")


SOCKETS = (
    SocketDescription(
        "/api/now/live",
        "What `GET /api/now` answers: at once, as it changes, and every half second, so that silence means a lost connection.",
        sends=(RobotsNow,),
    ),
    SocketDescription(
        "/api/cells/{cell}/live",
        "The cell's run and who is in control: at once, as they change, and each second. Closed with 1008 where there is no such cell.",
        sends=(CellLive,),
        parameters={"cell": ("Name of the cell.", "lwr4_bench")},
    ),
)


@router.websocket("/api/now/live")
async def watch_robots(websocket: WebSocket, conductor: ConductorDep) -> None:
    """What `GET /api/now` answers, as it changes, for anybody."""

    def look() -> list[CellNow]:
        return [cell_now(conductor, name) for name in sorted(conductor.active)]

    async def word(robots: list[CellNow], _changed: bool) -> RobotsNow:
        return RobotsNow(at=get_now(websocket), robots=robots)

    await keep_telling(websocket, look, word, PULSE_S)


@router.websocket("/api/cells/{cell}/live")
async def watch_cell(websocket: WebSocket, cell: str, conductor: ConductorDep, control: ControlDep, cells: CellsDep) -> None:
    """The cell's run and who is in control, as they change; closed with 1008 where there is no such cell."""
    try:
        await asyncio.to_thread(control_settings, cells, cell)
    except NotFound as error:
        await websocket.accept()
        await websocket.close(POLICY_VIOLATION, str(error)[:120])
        return

    def look() -> tuple[object, ...]:
        active = conductor.active.get(cell)
        run = None if active is None else (active.id, active.state, active.changed_at, active.row.finished_steps)
        return run, _what_is_told_of_control_at_once(control, cell)

    async def word(_state: tuple[object, ...], _changed: bool) -> CellLive:
        settings = await asyncio.to_thread(control_settings, cells, cell)
        active = conductor.active.get(cell)
        run = None if active is None else answer_now(conductor, control, get_now(websocket), active.row)
        return CellLive(run=run, control=answer_control(control, cell, settings, get_now(websocket)))

    await keep_telling(websocket, look, word, FIGURES_S)


def _what_is_told_of_control_at_once(control: ControlRegistry, cell: str) -> tuple[object, ...]:
    """Who is in control, who asks for it, how the last one who asked fared."""
    holder, request, ended = control.holder(cell), control.request(cell), control.last_request(cell)
    return (
        None if holder is None else (holder.who, holder.fence),
        None if request is None else (request.asker.fence, request.due),
        None if ended is None else (ended.fence, ended.outcome),
    )
