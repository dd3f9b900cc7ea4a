"""Runs: queued by operator or MES, shown, released by an operator at the cell, commanded, read."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Literal

from fastapi import APIRouter, Header, Query, Response
from pydantic import Field
from sqlalchemy import select
from sqlalchemy.exc import IntegrityError
from starlette.status import HTTP_202_ACCEPTED

from core.cell import Cell
from core.errors import BadPayload
from core.result import Result
from core.sessions.leased import Renewal
from server import audit, downloads, run_ledger
from server.dependencies import Asking, Here, Now, Stored
from server.errors import Conflict
from server.packml import Command, State
from server.payload_answer import PayloadAnswer, payload_answer
from server.run_schemas import EventMessage, LiveMessage, RunAnswer, RunOrder, RunPlan
from server.run_tables import RunRow
from server.runner.run_folder import RECORDING, REPORT
from server.schemas import Answer, Body
from server.service import Service

router = APIRouter(prefix="/api/runs", tags=["runs"])

Key = Annotated[str | None, Header(alias="Idempotency-Key", min_length=1, max_length=128)]
PLANNING_S = 5
"""When to ask again after queueing."""


class Commanded(StrEnum):
    """What may be asked of a run."""

    hold = "hold"
    resume = "resume"
    stop = "stop"
    abort = "abort"
    clear = "clear"


COMMANDS = {name: command for command, name in run_ledger.OFFERED.items()}
WITHOUT_CONTROL = frozenset({Commanded.stop, Commanded.abort})
"""Who sees that the robot has to stop need not be in control of it."""


class Sent(Body):
    """What makes a command of whoever is in control count once and now.

    Args:
        fence: of their control; `number` counts their commands up; `stamp_s` is the newest stamp that the server sent them.
    """

    fence: int
    number: int = Field(ge=0)
    stamp_s: float


class CommandBody(Body):
    """A command; `sent` may be left out of stop and abort."""

    command: Commanded
    sent: Sent | None = None


class ReleaseBody(Body):
    """What is released: exactly the plan that was shown."""

    plan_sha256: str
    offer: str
    sent: Sent


class PlanAnswer(Answer):
    """A plan that waits for its release.

    Args:
        offer: comes back with the release; good for `expires_s` seconds.
    """

    run: str
    plan: RunPlan
    offer: str
    expires_s: float


@router.post("", status_code=HTTP_202_ACCEPTED)
def queue_run(order: RunOrder, response: Response, here: Here, asking: Asking, now: Now, idempotency_key: Key = None) -> RunAnswer:
    """Queues a run; nothing moves before an operator at the cell has released its plan. The same `Idempotency-Key` makes one run."""
    body = order.model_dump_json().encode()
    check_payload(here.cells.load(order.cell), order)
    try:
        with here.store.write() as db:
            made = None if idempotency_key is None else run_ledger.made_before(db, asking.who, idempotency_key, body)
            row = run_ledger.queue(db, order, asking.who, now) if made is None else run_ledger.load(db, made)
            if made is None:
                if idempotency_key is not None:
                    run_ledger.once(db, asking.who, idempotency_key, body, row.id, now)
                audit.record(db, asking.who, "run.queue", {"run": row.id, "cell": order.cell}, now=now)
            found = run_ledger.answer(row)
    except IntegrityError as error:
        raise Conflict(f"Idempotency-Key {idempotency_key!r}: the first request is still under way; ask again") from error
    here.conductor.wake()
    response.headers["Location"] = f"/api/runs/{found.run}"
    response.headers["Retry-After"] = str(PLANNING_S)
    return found


@router.get("")
def list_runs(
    store: Stored, cell: str | None = None, state: State | None = None, limit: Annotated[int, Query(ge=1, le=500)] = 50
) -> list[RunAnswer]:
    """Newest first."""
    query = select(RunRow).order_by(RunRow.id.desc()).limit(limit)
    query = query if cell is None else query.where(RunRow.cell == cell)
    query = query if state is None else query.where(RunRow.state == state)
    with store.read() as db:
        return [run_ledger.answer(row) for row in db.scalars(query)]


@router.get("/{run}")
def read_run(run: str, here: Here) -> RunAnswer:
    """One run as it stands now."""
    return answered(here, run)


@router.get("/{run}/plan")
def read_plan(run: str, here: Here) -> PlanAnswer:
    """What is going to happen: to be looked at before it is released."""
    with here.store.read() as db:
        row = run_ledger.load(db, run)
    if row.plan is None:
        raise Conflict(
            f"run {run}: there is no plan yet, it is in {row.state}; wait until it is Idle", run_ledger.offered(State(row.state))
        )
    plan = RunPlan.model_validate_json(row.plan)
    return PlanAnswer(run=run, plan=plan, offer=here.offers.make(run, plan.sha256), expires_s=here.offers.length_s)


@router.post("/{run}/release")
async def release_run(run: str, body: ReleaseBody, here: Here, asking: Asking) -> RunAnswer:
    """An operator at the cell lets the shown plan begin; void (409) when anything has changed or the offer is older than 60 s."""
    await here.releases.release(run, asking.who, body.plan_sha256, body.offer, renewal(body.sent))
    return answered(here, run)


@router.post("/{run}/commands")
async def command_run(run: str, body: CommandBody, here: Here, asking: Asking, now: Now) -> RunAnswer:
    """Holds, resumes, stops, aborts or clears. All but stop and abort need control of the cell."""
    with here.store.read() as db:
        cell = run_ledger.load(db, run).cell
    if body.command not in WITHOUT_CONTROL:
        if body.sent is None:
            raise Conflict(f"command {body.command}: needs control of cell {cell!r}; send `sent` with your fence, number and stamp")
        here.control.command(cell, asking.who, renewal(body.sent))
    await here.conductor.command(
        run,
        COMMANDS[body.command],
        f"{body.command} was asked for by {asking.who}.",
        lambda db: audit.record(db, asking.who, f"run.{body.command}", {"run": run}, now=now),
    )
    return answered(here, run)


@router.delete("/{run}")
async def cancel_run(run: str, here: Here, asking: Asking, now: Now) -> RunAnswer:
    """Takes back a run that has not been released; one that moves is stopped at the cell instead."""
    with here.store.read() as db:
        row = run_ledger.load(db, run)
    if row.state not in (State.RESETTING, State.IDLE):
        raise run_ledger.refusal(row, "cancel")
    await here.conductor.command(
        run,
        Command.STOP,
        f"cancelled by {asking.who}.",
        lambda db: audit.record(db, asking.who, "run.cancel", {"run": run}, now=now),
    )
    return answered(here, run)


@router.get("/{run}/result")
def read_result(run: str, store: Stored) -> PayloadAnswer:
    """What the robot carries, with uncertainties."""
    with store.read() as db:
        row = run_ledger.load(db, run)
    if row.result is None:
        raise Conflict(f"run {run}: there is no result, it is in {row.state}" + ("" if row.reason is None else f" ({row.reason})"))
    return payload_answer(run, Result.model_validate_json(row.result))


@router.get("/{run}/recording", response_class=Response, responses=downloads.ZIPPED)
def download_recording(run: str, here: Here) -> Response:
    """The samples of a run as a zip of its recording folder; also of one that ended early."""
    missing = f"run {run}: has no recording, it is in {_state_of(here, run)}; one is there once a robot that has moved stands again"
    return downloads.zipped(here.settings.recordings_folder / run / RECORDING, f"run-{run}", missing)


@router.get("/{run}/report", response_class=Response, responses=downloads.PAGE)
def download_report(run: str, here: Here) -> Response:
    """The report of a run that came through, as a page."""
    missing = f"run {run}: has no report, it is in {_state_of(here, run)}; a report comes with a run that is Complete"
    return downloads.page(here.settings.recordings_folder / run / REPORT, f"run-{run}", missing)


@router.get("/{run}/events")
def read_events(
    run: str, here: Here, after: Annotated[int, Query(ge=0)] = 0, kind: Literal["event", "samples"] | None = None
) -> list[LiveMessage]:
    """What has happened behind a sequence number, and the newest samples: the same messages as on the websocket `live`."""
    with here.store.read() as db:
        run_ledger.load(db, run)
        messages: list[LiveMessage] = [EventMessage.model_validate_json(text) for text in run_ledger.told(db, run, after)]
    active = here.conductor.of_run(run)
    if active is not None and active.newest is not None:
        messages.append(active.newest.batch)
    return [message for message in messages if kind in (None, message.kind)]


def _state_of(here: Service, run: str) -> str:
    with here.store.read() as db:
        return run_ledger.load(db, run).state


def answered(here: Service, run: str) -> RunAnswer:
    """A run with its progress."""
    with here.store.read() as db:
        row = run_ledger.load(db, run)
    active = here.conductor.of_run(run)
    newest = None if active is None or active.newest is None else active.newest.batch
    return run_ledger.answer(row) if newest is None else run_ledger.answer(row, newest.progress, newest.eta_s)


def check_payload(cell: Cell, order: RunOrder) -> None:
    """The cell knows the payload, or has one to begin with.

    Raises:
        BadPayload: it does not.
    """
    known = ", ".join(cell.payloads)
    if order.payload is not None and order.payload not in cell.payloads:
        raise BadPayload("payload", repr(order.payload), f"one of {known or 'none'}, which cell {cell.name!r} knows")
    if not cell.payloads:
        raise BadPayload("payload", f"no payload in cell {cell.name!r}", "one that the simulated robot can carry; add it to cell.toml")


def renewal(sent: Sent) -> Renewal:
    """What the control of a cell checks."""
    return Renewal(sent.fence, sent.number, sent.stamp_s)
