"""Runs in the store: every change of a run and the events that tell of it are kept together or not at all."""

from __future__ import annotations

import secrets
from collections.abc import Iterable, Sequence
from datetime import datetime
from hashlib import sha256

from pydantic import TypeAdapter
from sqlalchemy import select
from sqlalchemy.orm import Session

from core.events import Event
from server import webhooks
from server.errors import Conflict, NotFound, Unprocessable
from server.packml import COMPLETED, FINAL, Command, State, commanded, job_state, legal_commands
from server.run_schemas import EventMessage, Happening, RunAnswer, RunOrder, StateChanged
from server.run_tables import IdempotencyKey, RunEventRow, RunRow

Step = Command | None
"""A command, or None where an acting state has done what it does."""

OFFERED = {
    Command.HOLD: "hold", Command.UNHOLD: "resume", Command.STOP: "stop", Command.ABORT: "abort", Command.CLEAR: "clear",
}  # fmt: skip
"""What a person may command, by the name that the API gives it. A run begins by its release and ends once, so neither start nor reset."""

_happening: TypeAdapter[Happening] = TypeAdapter(Happening)


def new_id(now: datetime) -> str:
    """An identifier that sorts by time."""
    return f"{round(now.timestamp() * 1000):012x}{secrets.token_hex(5)}"


def offered(state: State) -> list[str]:
    """What a person may command in this state."""
    return [OFFERED[command] for command in legal_commands(state) if command in OFFERED]


def queue(db: Session, order: RunOrder, who: str, now: datetime) -> RunRow:
    """A new run, which waits for its cell."""
    row = RunRow(id=new_id(now), cell=order.cell, order=order.model_dump_json(), state=State.RESETTING, requested_by=who, requested_at=now)
    row.released = row.aborted = False
    row.sequence = 0
    db.add(row)
    db.flush()
    tell(db, row, [_state_changed(row)], now)
    return row


def once(db: Session, who: str, key: str, body: bytes, made: str, now: datetime) -> None:
    """Remembers what a request made, in the transaction that makes it."""
    db.add(IdempotencyKey(caller=who, key=key, body_sha256=sha256(body).hexdigest(), made=made, made_at=now))


def made_before(db: Session, who: str, key: str, body: bytes) -> str | None:
    """What the same request has made already.

    Raises:
        Unprocessable: the key came with another body.
    """
    row = db.get(IdempotencyKey, (who, key))
    if row is None:
        return None
    if row.body_sha256 != sha256(body).hexdigest():
        raise Unprocessable(f"Idempotency-Key {key[:60]!r}: was used for another body already; take a new key for a new request")
    return row.made


def load(db: Session, run: str) -> RunRow:
    """One run.

    Raises:
        NotFound: there is none.
    """
    row = db.get(RunRow, run)
    if row is None:
        raise NotFound("run", run)
    return row


def steps(db: Session, row: RunRow, path: Iterable[Step], now: datetime) -> list[EventMessage]:
    """Takes a run through states; each is an event.

    Raises:
        IllegalCommandError: a command is not legal where the run then is.
    """
    messages: list[EventMessage] = []
    for step in path:
        state = State(row.state)
        row.state = COMPLETED[state] if step is None else commanded(state, step)
        row.aborted = row.aborted or row.state == State.ABORTED
        messages += tell(db, row, [_state_changed(row)], now)
        if row.ended_at is None and row.state in (*FINAL, State.ABORTED):
            row.ended_at = now
            webhooks.enqueue(db, answer(row), new_id, now)
    return messages


def tell(db: Session, row: RunRow, events: Sequence[Event], now: datetime) -> list[EventMessage]:
    """Appends to what happened to the run."""
    messages = []
    for event in events:
        row.sequence += 1
        message = EventMessage(sequence=row.sequence, at=now, event=_happening.validate_python(event))
        db.add(RunEventRow(run=row.id, sequence=row.sequence, body=message.model_dump_json()))
        messages.append(message)
    return messages


def told(db: Session, run: str, after: int) -> list[str]:
    """Bodies of the run's events behind a sequence number."""
    query = select(RunEventRow.body).where(RunEventRow.run == run, RunEventRow.sequence > after).order_by(RunEventRow.sequence)
    return list(db.scalars(query))


def waiting(db: Session) -> list[RunRow]:
    """The first run of each cell that is not over; Aborted is not over before it is cleared."""
    first: dict[str, RunRow] = {}
    for row in db.scalars(select(RunRow).where(RunRow.state.not_in(FINAL)).order_by(RunRow.id)):
        first.setdefault(row.cell, row)
    return list(first.values())


def close_crashed(db: Session, now: datetime) -> list[str]:
    """Aborts the runs that an earlier service left under way; those that only waited go on waiting. Returns which had begun to move."""
    closed = []
    for row in db.scalars(select(RunRow).where(RunRow.state.not_in((*FINAL, State.ABORTED, State.RESETTING)))):
        row.reason = f"the service ended while the run was in {row.state}; the robot was stopped. Look at the cell, then clear the run."
        moved = row.released
        if row.state == State.CLEARING:
            steps(db, row, [None], now)
        else:
            steps(db, row, [None] if row.state == State.ABORTING else [Command.ABORT, None], now)
        if moved:
            closed.append(row.id)
    return closed


def answer(row: RunRow, progress: float = 0.0, eta_s: float | None = None) -> RunAnswer:
    """The run as it leaves the service."""
    state = State(row.state)
    return RunAnswer(
        run=row.id,
        cell=row.cell,
        order=RunOrder.model_validate_json(row.order),
        state=state,
        job_state=job_state(state, released=row.released, aborted=row.aborted),
        commands=offered(state),
        released=row.released,
        reason=row.reason,
        in_the_way=row.in_the_way,
        progress=1.0 if state is State.COMPLETE else progress,
        eta_s=eta_s,
        sequence=row.sequence,
        requested_by=row.requested_by,
        requested_at=row.requested_at,
        released_by=row.released_by,
        released_at=row.released_at,
        ended_at=row.ended_at,
    )


def refusal(row: RunRow, what: str) -> Conflict:
    """Something that the run's state does not allow, with what it does allow."""
    legal = offered(State(row.state))
    return Conflict(f"run {row.id}: {what} is not possible in {row.state}; legal commands here: {', '.join(legal) or 'none'}", legal)


def _state_changed(row: RunRow) -> StateChanged:
    state = State(row.state)
    job = job_state(state, released=row.released, aborted=row.aborted)
    return StateChanged(state=state, job_state=job, commands=offered(state), reason=row.reason)
