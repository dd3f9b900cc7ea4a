"""A run as it goes on: events and samples over a websocket, resumed by sequence number."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from typing import Annotated, Literal

from fastapi import APIRouter, Query, WebSocket
from starlette.websockets import WebSocketDisconnect

from server.http.asyncapi import SocketDescription
from server.http.dependencies import StoreDep
from server.http.errors import NotFound
from server.http.parameters import RunPath
from server.runner.live_schemas import LiveBatch
from server.runs import ledger as run_ledger
from server.runs.broadcast import PATIENCE_S, TooSlowError, drain
from server.runs.conductor import Conductor, ConductorDep
from server.runs.event_schemas import EventMessage, LiveMessage
from server.runs.packml import FINAL, State
from server.store.store import Store

router = APIRouter(tags=["runs"])

NORMAL, POLICY_VIOLATION, TRY_AGAIN = 1000, 1008, 1013

AfterQuery = Annotated[int, Query(ge=0, le=2**53, description="Sequence number of the last event that is known already.", examples=[12])]
KindQuery = Annotated[Literal["event", "samples"] | None, Query(description="Only messages of this kind; all where absent.")]
THIN = "`thin`: every second batch with its newest sample alone, as a screen draws them."
SamplesQuery = Annotated[Literal["all", "thin"], Query(description=THIN)]


SOCKETS = (
    SocketDescription(
        "/api/runs/{run}/live",
        "Events behind `after`, then everything as it happens, up to 50 batches of samples a second. Who reads slowly loses samples, never "
        "events. Closed with 1013 when it is not read, with 1008 where there is no such run, with 1000 at the end.",
        sends=(EventMessage, LiveBatch),
        parameters={"run": ("Identifier of the run.", "019ab1c2d3e44f1c2a9be7")},
        query={
            "after": {"type": "integer", "minimum": 0, "default": 0, "description": "Sequence number of the last event that is known."},
            "samples": {
                "type": "string",
                "enum": ["all", "thin"],
                "default": "all",
                "description": THIN,
            },
        },
    ),
)


@router.websocket("/api/runs/{run}/live")
async def watch_run(
    websocket: WebSocket, run: str, store: StoreDep, conductor: ConductorDep, after: AfterQuery = 0, samples: SamplesQuery = "all"
) -> None:
    """Events behind `after`, then everything as it happens; closed with 1013 when it is not read, with 1000 at the end."""
    await websocket.accept()
    try:
        sending = asyncio.create_task(_send(websocket, run, store, conductor, after, thin=samples == "thin"))
        gone = asyncio.create_task(_wait_until_gone(websocket))
        await asyncio.wait((sending, gone), return_when=asyncio.FIRST_COMPLETED)
        gone.cancel()
        if not sending.done():
            sending.cancel()
            return
        await sending
        await websocket.close(NORMAL)
    except NotFound as error:
        await websocket.close(POLICY_VIOLATION, error.message.code)
    except TooSlowError as error:
        with suppress(RuntimeError):
            await asyncio.wait_for(websocket.close(TRY_AGAIN, error.message.code), 1.0)
    except (WebSocketDisconnect, TimeoutError):
        return


@router.get("/api/runs/{run}/events")
def read_events(run: RunPath, store: StoreDep, conductor: ConductorDep, after: AfterQuery = 0, kind: KindQuery = None) -> list[LiveMessage]:
    """What has happened behind a sequence number, and the newest samples: the same messages as on the websocket `live`."""
    _, told = _load_events(store, conductor, run, after)
    messages: list[LiveMessage] = [EventMessage.model_validate_json(text) for _, text in told]
    active = conductor.of_run(run)
    if active is not None and active.newest is not None:
        messages.append(active.newest.batch)
    return [message for message in messages if kind in (None, message.kind)]


async def _send(websocket: WebSocket, run: str, store: Store, conductor: Conductor, after: int, *, thin: bool) -> None:
    """What the store knows, then what comes; an event that is in both is sent once."""
    broadcast = conductor.broadcast(run)
    subscription = broadcast.subscribe(thin=thin)
    try:
        over, told = await asyncio.to_thread(_load_events, store, conductor, run, after)
        for sequence, text in told:
            async with asyncio.timeout(PATIENCE_S):
                await websocket.send_text(text)
            after = sequence
        active = conductor.of_run(run)
        if active is not None and active.newest is not None:  # of a robot on hold nothing newer comes
            await websocket.send_text(active.newest.batch.model_dump_json())
        if not over:
            await drain(subscription, websocket.send_text, after=after)
    except TimeoutError:
        raise TooSlowError("runs-watcher-too-slow", limit_s=PATIENCE_S) from None
    finally:
        broadcast.unsubscribe(subscription)


def _load_events(store: Store, conductor: Conductor, run: str, after: int) -> tuple[bool, list[tuple[int, str]]]:
    """Whether nothing more can come, and what has come, with sequence numbers: from memory where the run has its cell."""
    active = conductor.of_run(run)
    if active is not None:
        return False, [(sequence, text) for sequence, text in list(active.events) if sequence > after]
    with store.read() as db:
        row = run_ledger.load_run(db, run)
        over = conductor.of_run(run) is None and State(row.state) in (*FINAL, State.ABORTED)
        return over, run_ledger.list_events(db, run, after)


async def _wait_until_gone(websocket: WebSocket) -> None:
    """Nobody commands here; what comes is not looked at."""
    with suppress(WebSocketDisconnect):
        while True:
            await websocket.receive_text()
