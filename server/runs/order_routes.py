"""The queue of each cell: what was ordered by whom, what it waits for, and whether STOP would end it."""

from __future__ import annotations

import asyncio
from datetime import datetime
from enum import StrEnum
from typing import Annotated

from fastapi import APIRouter, Query, WebSocket
from pydantic import Field
from sqlalchemy import select

from server.http.asyncapi import SocketDescription
from server.http.dependencies import NowDep, StoreDep, get_now
from server.http.schemas import Answer
from server.http.telling import keep_telling
from server.runs.answer import answer_now
from server.runs.conductor import Conductor, ConductorDep
from server.runs.lease import ControlDep, ControlRegistry
from server.runs.packml import FINAL, State
from server.runs.schemas import RunPublic
from server.runs.tables import RunRow
from server.store.store import Store

router = APIRouter(prefix="/api/orders", tags=["orders"])

PULSE_S = 1.0
"""How often something is said although nothing has changed."""


class WaitsFor(StrEnum):
    """What has to happen before an order goes on."""

    order = "order"
    plan = "plan"
    release = "release"
    resume = "resume"
    path = "path"
    clear = "clear"


WAITS: dict[State, WaitsFor] = {
    State.RESETTING: WaitsFor.plan,
    State.IDLE: WaitsFor.release,
    State.HELD: WaitsFor.resume,
    State.SUSPENDED: WaitsFor.path,
    State.ABORTED: WaitsFor.clear,
}
"""Of the order that has its cell; in other states it goes on by itself."""


class OrderPublic(Answer):
    """A run that is not over, in the queue of its cell."""

    cell: str = Field(description="Whose queue.", examples=["lwr4_bench"])
    position: int = Field(description="In the queue; 0 has the cell.", examples=[0])
    waits_for: WaitsFor | None = Field(
        description="The order before it (order), its plan, a person's release, Resume, a free path, or that the aborted run is cleared; "
        "null while it goes on by itself.",
        examples=["release"],
    )
    ended_by_stop: bool = Field(description="Whether STOP at this cell would end it now; those behind it stay.", examples=[True])
    run: RunPublic = Field(description="The run itself, with who sent it.")


class OrdersLive(Answer):
    """What the websocket sends: at once, with every change, and each second a sign of life."""

    at: datetime = Field(description="The service's time.", examples=["2026-03-01T08:00:00.120Z"])
    orders: list[OrderPublic] | None = Field(description="Of all cells, by cell and position; null where nothing has changed.")


SOCKETS = (
    SocketDescription(
        "/api/orders/live",
        "The queues of all cells: at once, as they change, and each second, so that silence means a lost connection.",
        sends=(OrdersLive,),
    ),
)


@router.get("")
def list_orders(
    store: StoreDep,
    conductor: ConductorDep,
    control: ControlDep,
    now: NowDep,
    cell: Annotated[str | None, Query(description="Of this cell alone.", examples=["lwr4_bench"])] = None,
) -> list[OrderPublic]:
    """What is not over, by cell and in the order in which it is planned."""
    return [order for order in read_orders(store, conductor, control, now) if cell in (None, order.cell)]


@router.websocket("/live")
async def watch_orders(websocket: WebSocket, store: StoreDep, conductor: ConductorDep, control: ControlDep) -> None:
    """The queues of all cells, as they change."""

    def look() -> tuple[object, ...]:
        return conductor.queue_changes, tuple((each.id, each.state) for each in conductor.active.values())

    async def word(_state: tuple[object, ...], changed: bool) -> OrdersLive:
        now = get_now(websocket)
        return OrdersLive(at=now, orders=await asyncio.to_thread(read_orders, store, conductor, control, now) if changed else None)

    await keep_telling(websocket, look, word, PULSE_S)


def read_orders(store: Store, conductor: Conductor, control: ControlRegistry, now: datetime) -> list[OrderPublic]:
    """The queues of all cells."""
    with store.read() as db:
        rows = list(db.scalars(select(RunRow).where(RunRow.state.not_in(FINAL)).order_by(RunRow.cell, RunRow.id)))
    found: list[OrderPublic] = []
    for row in rows:
        run = answer_now(conductor, control, now, row)
        if run.state in FINAL:
            continue  # in memory; the database follows
        position = found[-1].position + 1 if found and found[-1].cell == run.cell else 0
        active = conductor.of_run(run.run) is not None
        waits = WAITS.get(run.state) if position == 0 else WaitsFor.order
        found.append(
            OrderPublic(cell=run.cell, position=position, waits_for=waits, ended_by_stop=active and "stop" in run.commands, run=run)
        )
    return found
