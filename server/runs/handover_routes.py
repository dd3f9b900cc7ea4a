"""Control of a cell is asked for, accepted or declined; how it passes stands in `server.runs.handover`."""

from __future__ import annotations

import asyncio
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from server.cells.folder import CellsDep
from server.http.dependencies import LaterDep, NowDep, StoreDep
from server.http.parameters import CellPath
from server.http.schemas import RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs.control_answer import ControlPublic, answer_control, control_settings
from server.runs.lease import ControlDep, next_fence
from server.runs.lease_routes import Device, record_later

router = APIRouter(prefix="/api/control/{cell}/request", tags=["control"])


class ControlRequestCreate(RequestBody):
    """Who asks is known; on which screen stands here."""

    device: Device


class ControlRequestUpdate(RequestBody):
    """What whoever is in control decides about a request."""

    fence: int = Field(description="Of whoever is in control.", examples=[41])
    request: int = Field(description="Fence of the request, as it was told.", examples=[42])
    accept: bool = Field(description="True passes control on, false keeps it.", examples=[True])


@router.post("")
async def ask_for_control(
    cell: CellPath, body: ControlRequestCreate, store: StoreDep, cells: CellsDep, control: ControlDep, caller: CallerDep, now: NowDep
) -> ControlPublic:
    """Asks for control. Then open the websocket `/api/control/{cell}/lease` and answer its stamps with the fence of `request`: control
    passes with one of these answers, once it was accepted, nobody has answered in time, or nobody is in control. A moving robot goes on."""
    settings = await asyncio.to_thread(control_settings, cells, cell)
    control.check_may_ask(cell, caller.who)

    def write() -> int:
        with store.write() as db:
            fence = next_fence(db, cell)
            audit.record(db, caller.who, "control.ask", {"cell": cell, "fence": fence, "device": body.device}, now=now)
            return fence

    control.ask(cell, caller.who, await asyncio.to_thread(write), settings.lease_s, body.device)
    return answer_control(control, cell, settings, now)


@router.post("/answer")
async def answer_request(
    cell: CellPath, body: ControlRequestUpdate, store: StoreDep, cells: CellsDep, control: ControlDep, caller: CallerDep, now: NowDep
) -> ControlPublic:
    """Whoever is in control accepts or declines."""
    settings = await asyncio.to_thread(control_settings, cells, cell)
    asker = control.check_asked(cell, caller.who, body.fence, body.request).asker
    deed = "control.accept" if body.accept else "control.decline"

    def write() -> None:
        with store.write() as db:
            audit.record(db, caller.who, deed, {"cell": cell, "fence": body.request, "asker": asker.who}, now=now)

    await asyncio.to_thread(write)
    control.answer(cell, caller.who, body.fence, body.request, accept=body.accept)
    return answer_control(control, cell, settings, now)


@router.delete("")
async def withdraw_request(
    cell: CellPath,
    fence: Annotated[int, Query(description="Of the request.", examples=[42])],
    store: StoreDep,
    cells: CellsDep,
    control: ControlDep,
    caller: CallerDep,
    now: NowDep,
    later: LaterDep,
) -> ControlPublic:
    """Whoever asks for control does so no more; nothing happens where that was over already."""
    settings = await asyncio.to_thread(control_settings, cells, cell)
    if control.asked_with(cell, caller.who, fence) is not None:
        control.let_go(cell, caller.who, fence)
        later.submit(record_later, store, audit.make_deed(caller.who, "control.withdraw", {"cell": cell, "fence": fence}, now=now))
    return answer_control(control, cell, settings, now)
