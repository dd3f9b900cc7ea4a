"""Runs: queued by operator or MES, listed, read, taken back."""

from __future__ import annotations

import asyncio
from typing import Annotated

from fastapi import APIRouter, Query, Response
from pydantic import Field
from sqlalchemy import select
from starlette.status import HTTP_202_ACCEPTED

from server.cells.folder import CellsDep
from server.http.dependencies import NowDep, SettingsDep, StoreDep
from server.http.parameters import RunPath
from server.http.schemas import RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs.answer import answer_now, answer_run
from server.runs.conductor import ConductorDep
from server.runs.lease import ControlDep
from server.runs.order import check_compared, check_order, complete_payload
from server.runs.packml import Command, RunOutcome, State
from server.runs.queue import IdempotencyKeyHeader, RunRequest, queue_once
from server.runs.reason import explain_cancellation
from server.runs.rest_of_run import rest_of
from server.runs.run_search import contain_words
from server.runs.schemas import RunCreate, RunOrder, RunPublic
from server.runs.tables import RunRow

router = APIRouter(prefix="/api/runs", tags=["runs"])


@router.post("", status_code=HTTP_202_ACCEPTED)
def queue_run(
    order: RunCreate,
    response: Response,
    store: StoreDep,
    cells: CellsDep,
    conductor: ConductorDep,
    settings: SettingsDep,
    caller: CallerDep,
    now: NowDep,
    idempotency_key: IdempotencyKeyHeader = None,
) -> RunPublic:
    """Queues a run; nothing moves before an operator at the cell has released its plan. The same `Idempotency-Key` makes one run."""
    body = order.model_dump_json().encode()
    cell = cells.read(order.cell).cell
    with store.read() as db:
        completed, carried = complete_payload(db, order, cell)
        check_compared(db, completed, settings.recordings_folder)
    check_order(completed, cell)
    return queue_once(store, conductor, response, RunRequest(caller.who, now, idempotency_key, body), completed, carried=carried)


class RunFilter(RequestBody):
    """Which runs a list has; what is absent does not matter."""

    cell: str | None = Field(default=None, description="Of this cell.", examples=["lwr4_bench"])
    payload: str | None = Field(default=None, description="With this payload.", examples=["steel_block"])
    saved_payload: str | None = Field(
        default=None,
        description="With this payload of the cell's tool library, by its identifier: under whatever name it had then.",
        examples=["019ab1c2d3e44f1c2a9be7"],
    )
    state: State | None = Field(default=None, description="In this state (PackML).")
    outcome: RunOutcome | None = Field(default=None, description="That ended so.")
    order_id: str | None = Field(default=None, description="For this job order.", examples=["JO-2026-004711"])
    work_order: str | None = Field(default=None, description="For this work order.", examples=["WO-88120"])
    serial_number: str | None = Field(default=None, description="Of what has this serial number.", examples=["SN-000482"])
    search: str | None = Field(
        default=None,
        max_length=200,
        description="That contain each of these words somewhere, letter case aside: in its identifier, payload, references, state or "
        "outcome, in the names of who ordered, released or accepted it; or on this day (UTC).",
        examples=["sn-000482 2026-03-01"],
    )
    before: str | None = Field(
        default=None, description="Before this run, such as the last of a list.", examples=["019ab1c2d3e44f1c2a9be7"]
    )
    limit: int = Field(default=50, ge=1, le=500, description="How many runs are answered at most.", examples=[50])


EQUAL = ("cell", "payload", "saved_payload", "state", "outcome", "order_id", "work_order", "serial_number")
"""What of a filter a run's column has to equal."""


@router.get("")
def list_runs(
    store: StoreDep, conductor: ConductorDep, control: ControlDep, now: NowDep, wanted: Annotated[RunFilter, Query()]
) -> list[RunPublic]:
    """Newest first, with their results in a few numbers; `before`, the last run of a list, gives the next one."""
    query = select(RunRow.id).order_by(RunRow.id.desc()).limit(wanted.limit)
    for name in EQUAL:
        if getattr(wanted, name) is not None:
            query = query.where(getattr(RunRow, name) == getattr(wanted, name))
    if wanted.before is not None:
        query = query.where(RunRow.id < wanted.before)
    query = query.where(*contain_words(wanted.search or ""))
    with store.read() as db:
        found = list(db.scalars(select(RunRow).where(RunRow.id.in_(db.scalars(query).all())).order_by(RunRow.id.desc())))
    return [answer_now(conductor, control, now, row) for row in found]


@router.get("/{run}")
def read_run(run: RunPath, conductor: ConductorDep, control: ControlDep, now: NowDep) -> RunPublic:
    """One run as it stands now."""
    return answer_run(conductor, control, now, run)


@router.delete("/{run}")
async def cancel_run(
    run: RunPath,
    conductor: ConductorDep,
    control: ControlDep,
    caller: CallerDep,
    now: NowDep,
    why: Annotated[str | None, Query(max_length=200, description="Why, for the run and the audit log.", examples=["wrong tool"])] = None,
) -> RunPublic:
    """Takes back a run that has not been released; one that moves is stopped at the cell instead."""
    row = await asyncio.to_thread(conductor.row_of, run)
    if row.state not in (State.RESETTING, State.IDLE):
        raise run_ledger.refusal(row, "cancel")
    await conductor.command(
        run,
        Command.STOP,
        explain_cancellation(caller.who, why),
        audit.make_deed(caller.who, "run.cancel", {"run": run} | ({"why": why} if why else {}), now=now),
    )
    return await asyncio.to_thread(answer_run, conductor, control, now, run)


@router.post("/{run}/continuation", status_code=HTTP_202_ACCEPTED)
def continue_run(
    run: RunPath,
    response: Response,
    store: StoreDep,
    conductor: ConductorDep,
    settings: SettingsDep,
    caller: CallerDep,
    now: NowDep,
    idempotency_key: IdempotencyKeyHeader = None,
) -> RunPublic:
    """Queues the rest of a run that ended before it was through, as a new run: its finished holds and rotations count."""
    ended = conductor.row_of(run)
    rest = rest_of(ended, settings.recordings_folder / run)
    order = RunOrder.model_validate_json(ended.order)
    return queue_once(
        store,
        conductor,
        response,
        RunRequest(caller.who, now, idempotency_key, f"continuation of {run}".encode()),
        order,
        rest,
        run_ledger.read_carried(ended),
    )
