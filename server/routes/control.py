"""Control of a cell: taken over HTTP, kept alive over a websocket whose stamps the screen sends back."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from fastapi import APIRouter, WebSocket
from pydantic import ValidationError
from starlette.websockets import WebSocketDisconnect

from core.sessions.leased import LEASE_S, Renewal
from server import audit
from server.control_lease import STAMP_PERIOD_S, Holder
from server.dependencies import Asking, Here, Now, let_in
from server.errors import NotAllowed, NotSignedIn
from server.schemas import Answer, Body, Name
from server.service import Service

router = APIRouter(prefix="/api/control", tags=["control"])

POLICY_VIOLATION = 1008
CHECK_S = 1.0
"""How often it is asked again whether the holder may move the robot."""


class ControlBody(Body):
    """The cell to take control of."""

    cell: Name


class ControlAnswer(Answer):
    """Who is in control.

    Args:
        fence: to be sent with every answered stamp and every command; null where nobody is.
        lease_s: how long one answered stamp lasts.
    """

    cell: str
    holder: str | None
    fence: int | None
    lease_s: float = LEASE_S
    stamp_period_s: float = STAMP_PERIOD_S


class Stamp(Answer):
    """What the server sends."""

    stamp_s: float


class StampAnswer(Body):
    """What the screen sends back, at once."""

    fence: int
    number: int
    stamp_s: float


@router.post("")
async def take_control(body: ControlBody, here: Here, asking: Asking, now: Now) -> ControlAnswer:
    """Takes control; then open the websocket `/api/control/{cell}/lease` and answer its stamps. Ends when they stop coming back."""
    here.cells.check_known(body.cell)
    with here.store.write() as db:
        holder = here.control.take(db, body.cell, asking.who)
        audit.record(db, asking.who, "control.take", {"cell": body.cell, "fence": holder.fence}, now=now)
    return _answer(body.cell, holder)


@router.get("/{cell}")
async def read_control(cell: str, here: Here) -> ControlAnswer:
    """Who is in control of a cell."""
    here.cells.check_known(cell)
    return _answer(cell, here.control.holder(cell))


@router.websocket("/{cell}/lease")
async def keep_control(websocket: WebSocket, cell: str, here: Here, asking: Asking) -> None:
    """Sends a stamp every 50 ms and takes the answers; control ends with the connection."""
    await websocket.accept()
    fence = -1
    stamps = asyncio.create_task(_stamps(websocket, here))
    try:
        while True:
            answer = StampAnswer.model_validate_json(await websocket.receive_text())
            fence = answer.fence
            renewal = Renewal(answer.fence, answer.number, answer.stamp_s)
            if here.control.renew(cell, asking.who, renewal):
                here.conductor.renew(cell, renewal)
    except ValidationError:
        await websocket.close(POLICY_VIOLATION, "an answer is {fence, number, stamp_s}")
    except (WebSocketDisconnect, RuntimeError):  # RuntimeError: closed by us
        pass
    finally:
        stamps.cancel()
        here.control.let_go(cell, asking.who, fence)


async def _stamps(websocket: WebSocket, here: Service) -> None:
    """Stamps as long as whoever gets them may have them: signing out elsewhere ends it within a second."""
    checked_s = here.control.clock()
    with suppress(WebSocketDisconnect, RuntimeError):
        while True:
            await websocket.send_text(Stamp(stamp_s=here.control.clock()).model_dump_json())
            await asyncio.sleep(STAMP_PERIOD_S)
            if here.control.clock() - checked_s > CHECK_S:
                checked_s = here.control.clock()
                try:
                    await asyncio.to_thread(let_in, websocket, here)
                except (NotAllowed, NotSignedIn) as refusal:
                    await websocket.close(POLICY_VIOLATION, str(refusal)[:120])
                    return


def _answer(cell: str, holder: Holder | None) -> ControlAnswer:
    return ControlAnswer(cell=cell, holder=None if holder is None else holder.who, fence=None if holder is None else holder.fence)
