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
from server import audit
from server.auth import Caller
from server.control_lease import STAMP_PERIOD_S, next_fence
from server.dependencies import Asking, Here, Now, let_in
from server.errors import NotAllowed, NotSignedIn
from server.schemas import Answer, Body, Name
from server.service import Service

router = APIRouter(prefix="/api/control", tags=["control"])

POLICY_VIOLATION = 1008
CHECK_S = 1.0
"""How often it is asked again whether the holder may move the robot."""
PAGE_LATE_S = 2.0
"""A page that has not responded for so long cannot be stopped from; its answers renew nothing."""


class ControlBody(Body):
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


class StampAnswer(Body):
    """What the screen sends back, at once.

    Args:
        page_age_s: since the page itself, not what answers beside it, gave a sign of life.
    """

    fence: int
    number: int
    stamp_s: float
    page_age_s: float = Field(0.0, ge=0.0)


@router.post("")
async def take_control(body: ControlBody, here: Here, asking: Asking, now: Now) -> ControlAnswer:
    """Takes control; then open the websocket `/api/control/{cell}/lease` and answer its stamps. Ends when they stop coming back."""
    settings = await asyncio.to_thread(_settings, here, body.cell)
    here.control.check_free(body.cell, asking.who)

    def write() -> int:
        with here.store.write() as db:
            fence = next_fence(db, body.cell)
            audit.record(db, asking.who, "control.take", {"cell": body.cell, "fence": fence}, now=now)
            return fence

    here.control.take(body.cell, asking.who, await asyncio.to_thread(write), settings.lease_s)
    return _answer(here, body.cell, settings)


@router.get("/{cell}")
async def read_control(cell: str, here: Here) -> ControlAnswer:
    """Who is in control of a cell, and over which link."""
    return _answer(here, cell, await asyncio.to_thread(_settings, here, cell))


@router.delete("/{cell}")
async def let_go_of_control(cell: str, fence: int, here: Here, asking: Asking) -> ControlAnswer:
    """Lets go of control that was taken with this fence; a robot that moves is put on hold when its lease ends."""
    settings = await asyncio.to_thread(_settings, here, cell)
    here.control.let_go(cell, asking.who, fence)
    return _answer(here, cell, settings)


@router.websocket("/{cell}/lease")
async def keep_control(websocket: WebSocket, cell: str, here: Here, asking: Asking) -> None:
    """Sends a stamp every 50 ms and takes the answers. A connection that is lost may be opened again with the same fence."""
    await websocket.accept()
    keeper = _Keeper(websocket, here, cell, asking)
    tasks = [asyncio.create_task(keeper.stamp()), asyncio.create_task(keeper.check())]
    try:
        while True:
            keeper.hear(StampAnswer.model_validate_json(await websocket.receive_text()))
    except ValidationError:
        with suppress(RuntimeError):
            await websocket.close(POLICY_VIOLATION, "an answer is {fence, number, stamp_s, page_age_s}")
    except (WebSocketDisconnect, RuntimeError):  # RuntimeError: closed by us
        pass
    finally:
        for task in tasks:
            task.cancel()


class _Keeper:
    """One websocket that keeps control. What sends the stamps waits for nothing but the socket."""

    def __init__(self, websocket: WebSocket, here: Service, cell: str, asking: Caller) -> None:
        self._websocket, self._here, self._cell, self._asking = websocket, here, cell, asking
        self._fence = -1

    def hear(self, answer: StampAnswer) -> None:
        """Takes the answer to a stamp."""
        here, self._fence = self._here, answer.fence
        holder = here.control.held_with(self._cell, self._asking.who, answer.fence)
        if holder is None:
            return
        if answer.stamp_s <= here.control.clock():
            holder.link.answered(answer.stamp_s, here.control.clock())
            here.metrics.runs.answered(here.control.clock() - answer.stamp_s)
        if answer.page_age_s > PAGE_LATE_S:
            here.conductor.note_late_page(self._cell, answer.page_age_s)
            return
        renewal = Renewal(answer.fence, answer.number, answer.stamp_s)
        if here.control.renew(self._cell, self._asking.who, renewal):
            here.conductor.renew(self._cell, renewal)

    async def stamp(self) -> None:
        """Sends stamps."""
        control = self._here.control
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                stamp_s = control.clock()
                await self._websocket.send_text(Stamp(stamp_s=stamp_s).model_dump_json())
                holder = control.held_with(self._cell, self._asking.who, self._fence)
                if holder is not None:
                    holder.link.sent(stamp_s)
                await asyncio.sleep(STAMP_PERIOD_S)

    async def check(self) -> None:
        """Ends control when whoever has it may no longer have it: signing out elsewhere does so within a second or two."""
        while True:
            await asyncio.sleep(CHECK_S)
            try:
                await asyncio.to_thread(let_in, self._websocket, self._here)
            except (NotAllowed, NotSignedIn) as refusal:
                self._here.control.let_go(self._cell, self._asking.who, self._fence)
                with suppress(RuntimeError):
                    await self._websocket.close(POLICY_VIOLATION, str(refusal)[:120])
                return
            except SQLAlchemyError:
                continue  # the database is away; it is asked again


def _settings(here: Service, name: str) -> CellControl:
    """How a cell's robot depends on whoever is in control; the usual where its file cannot be read: a robot in it may have to be cleared.

    Raises:
        NotFound: there is no such cell.
    """
    here.cells.check_known(name)
    try:
        return here.cells.read(name).cell.control
    except HeftError:
        return CellControl()


def _answer(here: Service, cell: str, settings: CellControl) -> ControlAnswer:
    holder = here.control.holder(cell)
    found = None if holder is None else holder.link.figures(holder.lease_s, here.control.clock())
    return ControlAnswer(
        cell=cell,
        holder=None if holder is None else holder.who,
        fence=None if holder is None else holder.fence,
        lease_s=settings.lease_s,
        hold_limit_s=settings.hold_limit_s,
        link=None if found is None else LinkAnswer(**found._asdict()),
    )
