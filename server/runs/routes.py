"""Runs: queued by operator or MES, listed, read, taken back."""

from __future__ import annotations

import asyncio
from typing import Annotated

from fastapi import APIRouter, Query, Response
from sqlalchemy import select
from starlette.status import HTTP_202_ACCEPTED

from core.cell.cell import Cell
from core.errors import BadPayload
from server.cells.folder import CellsDep
from server.http.dependencies import NowDep, SettingsDep, StoreDep
from server.people import audit
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs.answer import answer_now, answer_run
from server.runs.conductor import ConductorDep
from server.runs.lease import ControlDep
from server.runs.order import check_order
from server.runs.packml import Command, State
from server.runs.queue import IdempotencyKeyHeader, RunRequest, queue_once
from server.runs.reason import explain_cancellation
from server.runs.rest_of_run import rest_of
from server.runs.schemas import RunAnswer, RunOrder
from server.runs.tables import RunRow

router = APIRouter(prefix="/api/runs", tags=["runs"])


@router.post("", status_code=HTTP_202_ACCEPTED)
def queue_run(
    order: RunOrder,
    response: Response,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    caller: CallerDep,
    now: NowDep,
    idempotency_key: IdempotencyKeyHeader = None,
) -> RunAnswer:
    """Queues a run; nothing moves before an operator at the cell has released its plan. The same `Idempotency-Key` makes one run."""
    body = order.model_dump_json().encode()
    cell = cells.read(order.cell).cell
    check_order(order, cell)
    order = with_payload(order, cell)
    return queue_once(store, conductor, response, RunRequest(caller.who, now, idempotency_key, body), order)


@router.get("")
def list_runs(
    store: StoreDep,
    conductor: ConductorDep,
    control: ControlDep,
    now: NowDep,
    cell: str | None = None,
    payload: str | None = None,
    state: State | None = None,
    before: str | None = None,
    limit: Annotated[int, Query(ge=1, le=500)] = 50,
) -> list[RunAnswer]:
    """Newest first, with their results in a few numbers; `before`, the last run of a list, gives the next one."""
    query = select(RunRow).order_by(RunRow.id.desc()).limit(limit)
    for column, wanted in ((RunRow.cell, cell), (RunRow.payload, payload), (RunRow.state, state)):
        query = query if wanted is None else query.where(column == wanted)
    query = query if before is None else query.where(RunRow.id < before)
    with store.read() as db:
        found = list(db.scalars(query))
    return [answer_now(conductor, control, now, row) for row in found]


@router.get("/{run}")
def read_run(run: str, conductor: ConductorDep, control: ControlDep, now: NowDep) -> RunAnswer:
    """One run as it stands now."""
    return answer_run(conductor, control, now, run)


@router.delete("/{run}")
async def cancel_run(run: str, conductor: ConductorDep, control: ControlDep, caller: CallerDep, now: NowDep) -> RunAnswer:
    """Takes back a run that has not been released; one that moves is stopped at the cell instead."""
    row = await asyncio.to_thread(conductor.row_of, run)
    if row.state not in (State.RESETTING, State.IDLE):
        raise run_ledger.refusal(row, "cancel")
    await conductor.command(
        run,
        Command.STOP,
        explain_cancellation(caller.who),
        audit.make_deed(caller.who, "run.cancel", {"run": run}, now=now),
    )
    return await asyncio.to_thread(answer_run, conductor, control, now, run)


@router.post("/{run}/continuation", status_code=HTTP_202_ACCEPTED)
def continue_run(
    run: str,
    response: Response,
    store: StoreDep,
    conductor: ConductorDep,
    settings: SettingsDep,
    caller: CallerDep,
    now: NowDep,
    idempotency_key: IdempotencyKeyHeader = None,
) -> RunAnswer:
    """Queues the rest of a run that ended before it was through, as a new run: its finished holds and rotations count."""
    ended = conductor.row_of(run)
    rest = rest_of(ended, settings.recordings_folder / run)
    order = RunOrder.model_validate_json(ended.order)
    return queue_once(
        store, conductor, response, RunRequest(caller.who, now, idempotency_key, f"continuation of {run}".encode()), order, rest
    )


def with_payload(order: RunOrder, cell: Cell) -> RunOrder:
    """The order with its payload by name: the cell's first where it names none.

    Raises:
        BadPayload: the cell does not know it, or knows none.
    """
    if not cell.payloads:
        raise BadPayload("payload", "runs-cell-without-payload", cell=cell.name)
    name = order.payload or next(iter(cell.payloads))
    if name not in cell.payloads:
        raise BadPayload("payload", "runs-payload-unknown", payload=name, payloads=list(cell.payloads), cell=cell.name)
    return order.model_copy(update={"payload": name})
