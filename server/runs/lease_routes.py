"""Control of a cell: taken over HTTP, kept alive over a websocket whose stamps the screen sends back."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable
from contextlib import suppress
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Query, WebSocket
from pydantic import Field, ValidationError
from sqlalchemy.exc import SQLAlchemyError
from starlette.websockets import WebSocketDisconnect

from core.sessions.leased import Renewal
from server.cells.folder import CellsDep
from server.http.asyncapi import SocketDescription
from server.http.dependencies import LaterDep, NowDep, StoreDep, get_now
from server.http.errors import Conflict, NotAllowed, NotSignedIn
from server.http.parameters import CellPath
from server.http.schemas import Answer, Name, RequestBody
from server.people import audit
from server.people.audit import Deed, Detail
from server.people.auth import Caller, CallerDep
from server.people.door import Door, DoorDep
from server.runs.conductor import Conductor, ConductorDep
from server.runs.control_answer import ControlPublic, answer_control, control_settings
from server.runs.handover import EndedRequest
from server.runs.lease import STAMP_PERIOD_S, ControlDep, ControlRegistry, next_fence
from server.runs.metrics import RunMetrics, RunMetricsDep
from server.runs.packml import Command, State
from server.runs.reason import explain_command
from server.store.store import Store

router = APIRouter(prefix="/api/control", tags=["control"])
log = logging.getLogger("heft.control")

POLICY_VIOLATION = 1008
CHECK_S = 1.0
"""How often it is asked again whether the holder may move the robot."""
RECORD_ATTEMPTS, RECORD_AGAIN_S = 5, 0.5
"""Of what is written down after it has happened; the log has it in any case."""
PAGE_LATE_S = 2.0
"""A page that has not responded for so long cannot be stopped from; its answers renew nothing."""


Device = Annotated[str, Field("", max_length=40, description="Name of the screen, for others to know it by.", examples=["Tablet 2"])]


class ControlCreate(RequestBody):
    """The cell to take control of."""

    cell: Name = Field(description="Name of the cell to take control of.", examples=["lwr4_bench"])
    device: Device


class Stamp(Answer):
    """What the server sends."""

    stamp_s: float = Field(description="The service's clock, s; to be sent back at once.", examples=[81234.56])


class StampReply(RequestBody):
    """What the screen sends back, at once."""

    fence: int = Field(description="Of the control that was taken.", examples=[17])
    number: int = Field(description="Counts the answers and commands of this control up.", examples=[240])
    stamp_s: float = Field(description="The stamp that is answered, s.", examples=[81234.56])
    page_age_s: float = Field(
        default=0.0, ge=0.0, description="Since the page itself, not what answers beside it, gave a sign of life, s.", examples=[0.03]
    )


FenceQuery = Annotated[int, Query(description="Of the control that was taken, as `POST /api/control` answered it.", examples=[17])]


@router.post("")
async def take_control(
    body: ControlCreate, store: StoreDep, cells: CellsDep, control: ControlDep, caller: CallerDep, now: NowDep
) -> ControlPublic:
    """Takes control; then open the websocket `/api/control/{cell}/lease` and answer its stamps. Ends when they stop coming back."""
    settings = await asyncio.to_thread(control_settings, cells, body.cell)
    control.check_free(body.cell, caller.who)

    def write() -> int:
        with store.write() as db:
            fence = next_fence(db, body.cell)
            audit.record(db, caller.who, "control.take", {"cell": body.cell, "fence": fence, "device": body.device}, now=now)
            return fence

    control.take(body.cell, caller.who, await asyncio.to_thread(write), settings.lease_s, body.device)
    return answer_control(control, body.cell, settings, now)


@router.get("/{cell}")
async def read_control(cell: CellPath, cells: CellsDep, control: ControlDep, now: NowDep) -> ControlPublic:
    """Who is in control of a cell, since when, on which screen, over which link, and who asks for it."""
    return answer_control(control, cell, await asyncio.to_thread(control_settings, cells, cell), now)


@router.delete("/{cell}")
async def let_go_of_control(
    cell: CellPath,
    fence: FenceQuery,
    store: StoreDep,
    cells: CellsDep,
    control: ControlDep,
    conductor: ConductorDep,
    caller: CallerDep,
    now: NowDep,
    later: LaterDep,
) -> ControlPublic:
    """Releases control that was taken with this fence. Where somebody asks for it, it passes to them; else a robot that moves is put
    on hold first, and waits for whoever takes control next."""
    settings = await asyncio.to_thread(control_settings, cells, cell)
    if control.held_with(cell, caller.who, fence) is not None:
        if control.request(cell) is None:
            await _hold(conductor, cell, caller.who, now)
        control.let_go(cell, caller.who, fence)
        later.submit(record_later, store, audit.make_deed(caller.who, "control.release", {"cell": cell, "fence": fence}, now=now))
    return answer_control(control, cell, settings, now)


async def _hold(conductor: Conductor, cell: str, who: str, now: datetime) -> None:
    """A robot that moves while nobody will be in control keeps its place; what is about to change by itself does so by the lease."""
    active = conductor.active.get(cell)
    if active is None or active.state is not State.EXECUTE:
        return
    deed = audit.make_deed(who, "run.hold", {"run": active.id}, now=now)
    with suppress(Conflict):
        await conductor.command(active.id, Command.HOLD, explain_command("hold", who), deed)


SOCKETS = (
    SocketDescription(
        "/api/control/{cell}/lease",
        "A stamp every 50 ms, to be sent back at once: control lasts as long as the answers come. Closed with 1008 where it has ended.",
        sends=(Stamp,),
        receives=(StampReply,),
        parameters={"cell": ("Name of the cell.", "lwr4_bench")},
    ),
)


@router.websocket("/{cell}/lease")
async def keep_control(
    websocket: WebSocket,
    cell: str,
    store: StoreDep,
    control: ControlDep,
    conductor: ConductorDep,
    metrics: RunMetricsDep,
    door: DoorDep,
    caller: CallerDep,
    later: LaterDep,
) -> None:
    """Sends a stamp every 50 ms and takes the answers, of whoever is in control and of whoever asks for it. A connection that is lost may
    be opened again with the same fence."""
    await websocket.accept()

    def record_pass(ended: EndedRequest) -> None:
        detail: Detail = {"cell": cell, "fence": ended.fence, "from": ended.holder, "device": ended.device, "outcome": ended.outcome.value}
        later.submit(record_later, store, audit.make_deed(ended.who, "control.pass", detail, now=get_now(websocket)))

    keeper = _Keeper(websocket, cell, caller, control, conductor, metrics, door, record_pass)
    tasks = [asyncio.create_task(keeper.stamp()), asyncio.create_task(keeper.check())]
    try:
        while True:
            keeper.hear(StampReply.model_validate_json(await websocket.receive_text()))
    except ValidationError:
        with suppress(RuntimeError):
            await websocket.close(POLICY_VIOLATION, "runs-stamp-malformed")
    except (WebSocketDisconnect, RuntimeError):  # RuntimeError: closed by us
        pass
    finally:
        for task in tasks:
            task.cancel()


class _Keeper:
    """One websocket that keeps control. What sends the stamps waits for nothing but the socket."""

    def __init__(
        self,
        websocket: WebSocket,
        cell: str,
        caller: Caller,
        control: ControlRegistry,
        conductor: Conductor,
        metrics: RunMetrics,
        door: Door,
        record_pass: Callable[[EndedRequest], None],
    ) -> None:
        self._websocket, self._cell, self._caller = websocket, cell, caller
        self._control, self._conductor, self._metrics, self._door = control, conductor, metrics, door
        self._record_pass = record_pass
        self._fence = -1

    def hear(self, answer: StampReply) -> None:
        """Takes the answer to a stamp."""
        self._fence = answer.fence
        asker = self._control.asked_with(self._cell, self._caller.who, answer.fence)
        holder = asker or self._control.held_with(self._cell, self._caller.who, answer.fence)
        if holder is None:
            return
        if answer.stamp_s <= self._control.clock():
            holder.link.note_answer(answer.stamp_s, self._control.clock())
            self._metrics.observe_round_trip(self._control.clock() - answer.stamp_s)
        if answer.page_age_s > PAGE_LATE_S:
            if asker is None:
                self._conductor.note_late_page(self._cell, answer.page_age_s)
            return
        renewal = Renewal(answer.fence, answer.number, answer.stamp_s)
        if not self._control.renew(self._cell, self._caller.who, renewal):
            return
        self._conductor.renew(self._cell, renewal)
        ended = self._control.last_request(self._cell)
        if asker is not None and ended is not None:
            self._record_pass(ended)

    async def stamp(self) -> None:
        """Sends stamps."""
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                stamp_s = self._control.clock()
                await self._websocket.send_text(Stamp(stamp_s=stamp_s).model_dump_json())
                who = (self._cell, self._caller.who, self._fence)
                holder = self._control.held_with(*who) or self._control.asked_with(*who)
                if holder is not None:
                    holder.link.note_stamp(stamp_s)
                await asyncio.sleep(STAMP_PERIOD_S)

    async def check(self) -> None:
        """Ends control when whoever has it may no longer have it: signing out elsewhere does so within a second or two."""
        while True:
            await asyncio.sleep(CHECK_S)
            try:
                await asyncio.to_thread(self._door.let_in, self._websocket)
            except (NotAllowed, NotSignedIn) as refusal:
                self._control.let_go(self._cell, self._caller.who, self._fence)
                with suppress(RuntimeError):
                    await self._websocket.close(POLICY_VIOLATION, refusal.message.code)
                return
            except SQLAlchemyError:
                continue  # the database is away; it is asked again


def record_later(store: Store, deed: Deed) -> None:
    """Writes down what has happened to control already: it does not wait for the database. Not from the event loop."""
    for left in reversed(range(RECORD_ATTEMPTS)):
        try:
            with store.write() as db:
                audit.record_deed(db, deed)
        except SQLAlchemyError:
            log.warning("%s could not be written down: %s", deed.action, deed.model_dump_json(), extra={"attempts_left": left})
        else:
            return
        time.sleep(RECORD_AGAIN_S)
