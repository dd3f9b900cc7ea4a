"""Runs as they are asked for: each is queued once, however often the request comes."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, NamedTuple

from fastapi import Header, Response
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from server.http.dependencies import set_accepted_headers
from server.http.errors import Conflict
from server.people import audit
from server.runs import idempotency
from server.runs import ledger as run_ledger
from server.runs.conductor import Conductor
from server.runs.ledger import CarriedPayload
from server.runs.schemas import Motion, RestOfRun, RunOrder, RunPublic
from server.runs.tables import RunRow
from server.store.store import Store

IdempotencyKeyHeader = Annotated[
    str | None,
    Header(
        alias="Idempotency-Key",
        min_length=1,
        max_length=128,
        description="The same key with the same body makes one run, however often it is sent; with another body it is refused.",
        examples=["JO-2026-004711/1"],
    ),
]
PLANNING_S = 5
"""When to ask again after queueing."""


class RunRequest(NamedTuple):
    """Who asks for a run, and what makes two requests the same."""

    who: str
    now: datetime
    key: str | None
    body: bytes


def queue_once(
    store: Store,
    conductor: Conductor,
    response: Response,
    request: RunRequest,
    order: RunOrder,
    motion: Motion | None = None,
    carried: CarriedPayload | None = None,
) -> RunPublic:
    """The run that the request makes, or has made already.

    Args:
        carried: the payload of the tool library; None where it is one of cell.toml.

    Raises:
        Unprocessable: the key came with another body.
        BadCell, BadRobot: nothing can be planned in the cell as it is now.
        Conflict: the same request is just being answered.
    """
    try:
        with store.write() as db:
            made = None if request.key is None else idempotency.recall_request(db, request.who, request.key, request.body)
            row = _make(conductor, db, request, order, motion, carried) if made is None else run_ledger.load_run(db, made)
            found = run_ledger.build_answer(row)
    except IntegrityError as error:
        raise Conflict("request-key-busy", key=(request.key or "")[:60]) from error
    conductor.wake()
    set_accepted_headers(response, f"/api/runs/{found.run}", PLANNING_S)
    return found


def _make(
    conductor: Conductor, db: Session, request: RunRequest, order: RunOrder, motion: Motion | None, carried: CarriedPayload | None
) -> RunRow:
    conductor.load_plannable_cell(db, order.cell)
    row = run_ledger.add_run(db, order, request.who, request.now, motion, carried)
    if request.key is not None:
        idempotency.remember_request(db, request.who, request.key, request.body, row.id, request.now)
    audit.record(db, request.who, "run.queue", {"run": row.id, "cell": order.cell, **_origin(motion)}, now=request.now)
    return row


def _origin(motion: Motion | None) -> dict[str, str | None]:
    """What the run goes back to."""
    if motion is None:
        return {}
    return {"continues": motion.continues} if isinstance(motion, RestOfRun) else {"diagnosis": motion.diagnosis}
