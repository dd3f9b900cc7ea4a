"""What a console follows without asking again: every robot that a run has, and the run and the control of one cell.

Both websockets say everything at once, then what has changed, and the same again after a while: who hears nothing for longer has lost
the connection. Nothing here waits for the database.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress
from datetime import datetime
from typing import TypeVar

from fastapi import APIRouter, WebSocket
from starlette.websockets import WebSocketDisconnect

from server.cells.folder import CellsDep
from server.http.dependencies import get_now
from server.http.errors import NotFound
from server.http.schemas import Answer
from server.runs.answer import answer_now
from server.runs.broadcast import PATIENCE_S
from server.runs.conductor import ConductorDep
from server.runs.lease import ControlDep
from server.runs.lease_routes import ControlAnswer, answer_control, control_settings
from server.runs.now_routes import CellNow, cell_now
from server.runs.schemas import RunAnswer

router = APIRouter(tags=["now"])

LOOK_S = 0.1
"""How often it is looked whether something has changed."""
PULSE_S = 0.5
"""After so long the same is said again: often enough that a lost connection is noticed within some 1.5 s."""
FIGURES_S = 1.0
"""How often what changes all the time is said anew: progress, and the figures of the link."""
POLICY_VIOLATION = 1008

Said = TypeVar("Said")


class RobotsNow(Answer):
    """Every cell with a robot that a run has; `at` is the service's time."""

    at: datetime
    robots: list[CellNow]


class CellLive(Answer):
    """The run that has a cell, null where none has, and who is in control of it."""

    run: RunAnswer | None
    control: ControlAnswer


@router.websocket("/api/now/live")
async def watch_robots(websocket: WebSocket, conductor: ConductorDep) -> None:
    """What `GET /api/now` answers, as it changes, for anybody."""

    async def tell(said: list[CellNow] | None, silent_s: float) -> list[CellNow] | None:
        robots = [cell_now(conductor, name) for name in sorted(conductor.active)]
        if robots == said and silent_s < PULSE_S:
            return None
        await websocket.send_text(RobotsNow(at=get_now(websocket), robots=robots).model_dump_json())
        return robots

    await _keep_telling(websocket, tell)


@router.websocket("/api/cells/{cell}/live")
async def watch_cell(websocket: WebSocket, cell: str, conductor: ConductorDep, control: ControlDep, cells: CellsDep) -> None:
    """The cell's run and who is in control, as they change; closed with 1008 where there is no such cell."""
    try:
        await asyncio.to_thread(control_settings, cells, cell)
    except NotFound as error:
        await websocket.accept()
        await websocket.close(POLICY_VIOLATION, str(error)[:120])
        return

    async def tell(said: tuple[object, ...] | None, silent_s: float) -> tuple[object, ...] | None:
        active, holder = conductor.active.get(cell), control.holder(cell)
        at_once = (
            None if active is None else (active.id, active.state, active.changed_at, active.row.finished_steps),
            None if holder is None else (holder.who, holder.fence),
        )
        if at_once == said and silent_s < FIGURES_S:
            return None
        settings = await asyncio.to_thread(control_settings, cells, cell)
        run = None if active is None else answer_now(conductor, control, get_now(websocket), active.row)
        message = CellLive(run=run, control=answer_control(control, cell, settings))
        await websocket.send_text(message.model_dump_json())
        return at_once

    await _keep_telling(websocket, tell)


async def _keep_telling(websocket: WebSocket, tell: Callable[[Said | None, float], Awaitable[Said | None]]) -> None:
    """Until the other side is gone or does not read.

    Args:
        tell: sends what there is to say, given what was said last and how long ago, s, and returns it; None where nothing was sent.
    """
    loop = asyncio.get_running_loop()

    async def keep() -> None:
        said, at = None, loop.time()
        while True:
            async with asyncio.timeout(PATIENCE_S):
                told = await tell(said, loop.time() - at)
            if told is not None:
                said, at = told, loop.time()
            await asyncio.sleep(LOOK_S)

    async def wait_until_gone() -> None:
        with suppress(WebSocketDisconnect):
            while True:
                await websocket.receive_text()

    await websocket.accept()
    tasks = [asyncio.create_task(keep()), asyncio.create_task(wait_until_gone())]
    done, pending = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    for task in pending:
        task.cancel()
    for task in done:
        with suppress(WebSocketDisconnect, RuntimeError, TimeoutError):  # RuntimeError: closed while something was sent
            await task
