"""Control of a cell: taken over HTTP, kept alive over a websocket whose stamps the screen sends back."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from fastapi import APIRouter, WebSocket
from pydantic import Field, ValidationError
from sqlalchemy.exc import SQLAlchemyError
from starlette.websockets import WebSocketDisconnect

from core.cell.cell import Control as CellControl
from core.errors import HeftError
from core.sessions.leased import Renewal
from server.cells.folder import CellFolder, CellsDep
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import NotAllowed, NotSignedIn
from server.http.schemas import Answer, Name, RequestBody
from server.people import audit
from server.people.auth import Caller, CallerDep
from server.people.door import Door, DoorDep
from server.runs.conductor import Conductor, ConductorDep
from server.runs.lease import STAMP_PERIOD_S, ControlDep, ControlRegistry, next_fence
from server.runs.metrics import RunMetrics, RunMetricsDep

router = APIRouter(prefix="/api/control", tags=["control"])

POLICY_VIOLATION = 1008
CHECK_S = 1.0
"""How often it is asked again whether the holder may move the robot."""
PAGE_LATE_S = 2.0
"""A page that has not responded for so long cannot be stopped from; its answers renew nothing."""


class ControlBody(RequestBody):
    """The cell to take control of."""

    cell: Name


class LinkAnswer(Answer):
    """The connection of whoever is in control, in the last 60 s.

    Args:
        lost_share: of the stamps, those not answered within the lease.
        longest_gap_s: the longest time that control rested on one answer; the lease is what it may be.
        advised: whether the link is good enough for a release; over one that is not, a run is likely to be put on hold.
    """

    round_trip_p50_s: float
    round_trip_p99_s: float
    lost_share: float
    longest_gap_s: float
    answers: int
    window_s: float
    advised: bool


class ControlAnswer(Answer):
    """Who is in control.

    Args:
        fence: to be sent with every answered stamp and every command; null where nobody is.
        lease_s: how long one answered stamp lasts; `hold_limit_s` how long a run on hold waits for somebody to be in control again.
        link: null until there are enough answers to say anything.
    """

    cell: str
    holder: str | None
    fence: int | None
    lease_s: float
    hold_limit_s: float
    stamp_period_s: float = STAMP_PERIOD_S
    link: LinkAnswer | None


class Stamp(Answer):
    """What the server sends."""

    stamp_s: float


class StampAnswer(RequestBody):
    """What the screen sends back, at once.

    Args:
        page_age_s: since the page itself, not what answers beside it, gave a sign of life.
    """

    fence: int
    number: int
    stamp_s: float
    page_age_s: float = Field(0.0, ge=0.0)


@router.post("")
async def take_control(
    body: ControlBody, store: StoreDep, cells: CellsDep, control: ControlDep, caller: CallerDep, now: NowDep
) -> ControlAnswer:
    """Takes control; then open the websocket `/api/control/{cell}/lease` and answer its stamps. Ends when they stop coming back."""
    settings = await asyncio.to_thread(control_settings, cells, body.cell)
    control.check_free(body.cell, caller.who)

    def write() -> int:
        with store.write() as db:
            fence = next_fence(db, body.cell)
            audit.record(db, caller.who, "control.take", {"cell": body.cell, "fence": fence}, now=now)
            return fence

    control.take(body.cell, caller.who, await asyncio.to_thread(write), settings.lease_s)
    return answer_control(control, body.cell, settings)


@router.get("/{cell}")
async def read_control(cell: str, cells: CellsDep, control: ControlDep) -> ControlAnswer:
    """Who is in control of a cell, and over which link."""
    return answer_control(control, cell, await asyncio.to_thread(control_settings, cells, cell))


@router.delete("/{cell}")
async def let_go_of_control(cell: str, fence: int, cells: CellsDep, control: ControlDep, caller: CallerDep) -> ControlAnswer:
    """Lets go of control that was taken with this fence; a robot that moves is put on hold when its lease ends."""
    settings = await asyncio.to_thread(control_settings, cells, cell)
    control.let_go(cell, caller.who, fence)
    return answer_control(control, cell, settings)


@router.websocket("/{cell}/lease")
async def keep_control(
    websocket: WebSocket, cell: str, control: ControlDep, conductor: ConductorDep, metrics: RunMetricsDep, door: DoorDep, caller: CallerDep
) -> None:
    """Sends a stamp every 50 ms and takes the answers. A connection that is lost may be opened again with the same fence."""
    await websocket.accept()
    keeper = _Keeper(websocket, cell, caller, control, conductor, metrics, door)
    tasks = [asyncio.create_task(keeper.stamp()), asyncio.create_task(keeper.check())]
    try:
        while True:
            keeper.hear(StampAnswer.model_validate_json(await websocket.receive_text()))
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
    ) -> None:
        self._websocket, self._cell, self._caller = websocket, cell, caller
        self._control, self._conductor, self._metrics, self._door = control, conductor, metrics, door
        self._fence = -1

    def hear(self, answer: StampAnswer) -> None:
        """Takes the answer to a stamp."""
        self._fence = answer.fence
        holder = self._control.held_with(self._cell, self._caller.who, answer.fence)
        if holder is None:
            return
        if answer.stamp_s <= self._control.clock():
            holder.link.note_answer(answer.stamp_s, self._control.clock())
            self._metrics.observe_round_trip(self._control.clock() - answer.stamp_s)
        if answer.page_age_s > PAGE_LATE_S:
            self._conductor.note_late_page(self._cell, answer.page_age_s)
            return
        renewal = Renewal(answer.fence, answer.number, answer.stamp_s)
        if self._control.renew(self._cell, self._caller.who, renewal):
            self._conductor.renew(self._cell, renewal)

    async def stamp(self) -> None:
        """Sends stamps."""
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                stamp_s = self._control.clock()
                await self._websocket.send_text(Stamp(stamp_s=stamp_s).model_dump_json())
                holder = self._control.held_with(self._cell, self._caller.who, self._fence)
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


def control_settings(cells: CellFolder, name: str) -> CellControl:
    """How a cell's robot depends on whoever is in control; the usual where its file cannot be read: a robot in it may have to be cleared.

    Raises:
        NotFound: there is no such cell.
    """
    cells.check_known(name)
    try:
        return cells.read(name).cell.control
    except HeftError:
        return CellControl()


def answer_control(control: ControlRegistry, cell: str, settings: CellControl) -> ControlAnswer:
    """Who is in control of a cell as it is told, and over which link."""
    holder = control.holder(cell)
    found = None if holder is None else holder.link.figures(holder.lease_s, control.clock())
    return ControlAnswer(
        cell=cell,
        holder=None if holder is None else holder.who,
        fence=None if holder is None else holder.fence,
        lease_s=settings.lease_s,
        hold_limit_s=settings.hold_limit_s,
        link=None if found is None else LinkAnswer(**found._asdict()),
    )
