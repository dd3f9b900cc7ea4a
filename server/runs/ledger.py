"""Runs in the store: every change of a run and the events that tell of it are kept together or not at all."""

from __future__ import annotations

import secrets
from collections.abc import Iterable, Sequence
from datetime import datetime
from itertools import count
from typing import NamedTuple

from pydantic import TypeAdapter
from sqlalchemy import inspect, select
from sqlalchemy.orm import Session

from core.cell.cell import Payload
from core.errors import Lateness
from core.estimation.result import Result
from core.events import Event
from core.words.message import Message
from server.http.errors import Conflict, NotFound
from server.runner.plan_schemas import PlanHash
from server.runs import webhooks
from server.runs.event_schemas import EventMessage, Happening, StateChanged
from server.runs.packml import COMPLETED, FINAL, Command, IllegalCommandError, RunOutcome, State, apply_command, job_state, legal_commands
from server.runs.reason import CANCELLED, Reason, read_reason, set_reason
from server.runs.result_summary import summary_of
from server.runs.schemas import Motion, RunOrder, RunPublic
from server.runs.tables import RunEventRow, RunRow

Step = Command | None
"""A command, or None where an acting state has done what it does."""

OFFERED = {
    Command.HOLD: "hold", Command.UNHOLD: "resume", Command.STOP: "stop", Command.ABORT: "abort", Command.CLEAR: "clear",
}  # fmt: skip
"""What a person may command, by the name that the API gives it. A run begins by its release and ends once, so neither start nor reset."""

_MADE = count()
"""How many identifiers this process has made."""

_motion: TypeAdapter[Motion] = TypeAdapter(Motion)
_happening: TypeAdapter[Happening] = TypeAdapter(Happening)


class CarriedPayload(NamedTuple):
    """A payload of the tool library as a run carries it, whatever becomes of it in the library.

    Args:
        saved: its identifier; None of a run without it, which is none of its runs.
        known: what is known of it; None where that is its box alone.
    """

    saved: str | None
    known: Payload | None


def new_id(now: datetime) -> str:
    """An identifier that sorts by time, and in the same millisecond by which was made first."""
    return f"{round(now.timestamp() * 1000):012x}{next(_MADE) % 0x10000:04x}{secrets.token_hex(3)}"


def list_offered_commands(state: State) -> list[str]:
    """What a person may command in this state; nothing of a run that is over."""
    return [] if state in FINAL else [OFFERED[command] for command in legal_commands(state) if command in OFFERED]


def add_run(
    db: Session, order: RunOrder, who: str, now: datetime, motion: Motion | None = None, carried: CarriedPayload | None = None
) -> RunRow:
    """A new run of the procedure, or of something else; it waits for its cell.

    Args:
        carried: the payload of the tool library; None where it is one of cell.toml.
    """
    payload = None if order.empty else order.payload
    row = RunRow(id=new_id(now), cell=order.cell, payload=payload, order=order.model_dump_json(), state=State.RESETTING)
    row.order_id, row.work_order, row.serial_number = order.order_id, order.work_order, order.serial_number
    row.requested_by, row.requested_at = who, now
    if carried is not None:
        row.saved_payload = None if order.empty else carried.saved
        row.known_payload = None if carried.known is None else carried.known.model_dump_json()
    row.released = row.aborted = False
    row.motion = None if motion is None else motion.model_dump_json()
    row.sequence = row.journaled = row.finished_steps = row.steps = 0
    db.add(row)
    db.flush()
    keep(db, row, tell(row, [_state_changed(row)], now), ended=False)
    return row


def copy_row(row: RunRow) -> RunRow:
    """The run as an object of its own, which no session knows."""
    return RunRow(**{column.key: getattr(row, column.key) for column in inspect(RunRow).column_attrs})


def load_run(db: Session, run: str) -> RunRow:
    """One run.

    Raises:
        NotFound: there is none.
    """
    row = db.get(RunRow, run)
    if row is None:
        raise NotFound("runs-unknown", run=run[:80])
    return row


def read_carried(row: RunRow) -> CarriedPayload | None:
    """The payload of the tool library that a run carries; None where it is one of cell.toml."""
    if row.saved_payload is None and row.known_payload is None:
        return None
    return CarriedPayload(row.saved_payload, None if row.known_payload is None else Payload.model_validate_json(row.known_payload))


def motion_of(row: RunRow) -> Motion | None:
    """What the run does instead of the whole procedure."""
    return None if row.motion is None else _motion.validate_json(row.motion)


def load_result(row: RunRow) -> Result:
    """The result of a run.

    Raises:
        Conflict: it has none.
    """
    if row.result is None:
        reason = read_reason(row)
        if reason is None:
            raise Conflict("runs-no-result", run=row.id, state=row.state)
        raise Conflict("runs-no-result-because", run=row.id, state=row.state, cause=reason)
    return Result.model_validate_json(row.result)


def advance(row: RunRow, path: Iterable[Step], now: datetime) -> list[EventMessage]:
    """Takes a run through states; each is an event. Nothing is written.

    Raises:
        IllegalCommandError: a command is not legal where the run then is.
    """
    messages: list[EventMessage] = []
    for step in path:
        state = State(row.state)
        if step is not None and state in FINAL:  # the machine may begin anew, this run may not
            raise IllegalCommandError(state, step, ())
        row.state = COMPLETED[state] if step is None else apply_command(state, step)
        row.aborted = row.aborted or row.state == State.ABORTED
        row.held_since = now if row.state == State.HELD else row.held_since if row.state == State.UNHOLDING else None
        if row.ended_at is None and row.state in (*FINAL, State.ABORTED):
            row.ended_at, row.outcome = now, find_outcome(row)
        messages += tell(row, [_state_changed(row)], now)
    return messages


def find_outcome(row: RunRow) -> RunOutcome:
    """How a run has ended that has just come to its end, by its state and its reason."""
    if row.state == State.COMPLETE:
        return RunOutcome.COMPLETED
    if row.state == State.ABORTED:
        return RunOutcome.ABORTED
    if row.reason_kind == CANCELLED:
        return RunOutcome.CANCELLED
    return RunOutcome.REFUSED if row.aborted else RunOutcome.STOPPED


def keep(db: Session, row: RunRow, messages: Sequence[EventMessage], *, ended: bool) -> None:
    """Writes what was told of a run; whoever wants to hear of its end is told of that."""
    for message in messages:
        db.add(RunEventRow(run=row.id, sequence=message.sequence, body=message.model_dump_json()))
    if ended:
        webhooks.enqueue(db, build_answer(row), new_id, row.ended_at or messages[-1].at)


def keep_steps(db: Session, row: RunRow, path: Iterable[Step], now: datetime) -> list[EventMessage]:
    """`advance` and `keep` for a run that no process has."""
    over = row.ended_at is not None
    messages = advance(row, path, now)
    keep(db, row, messages, ended=not over and row.ended_at is not None)
    return messages


def end(db: Session, row: RunRow, reason: Reason, now: datetime) -> None:
    """Closes a run that no process carries: as it was told to end; Stopped before any motion; else Aborted."""
    row.aborted = True
    set_reason(row, reason)
    keep_steps(db, row, find_end_path(State(row.state)), now)


def find_end_path(state: State) -> list[Step]:
    """How a run that does not come through ends."""
    if state in (State.STOPPING, State.ABORTING):
        return [None]
    return [Command.STOP if state in (State.RESETTING, State.IDLE) else Command.ABORT, None]


def tell(row: RunRow, events: Sequence[Event], now: datetime) -> list[EventMessage]:
    """Numbers what happened to the run. Nothing is written."""
    messages = []
    for event in events:
        row.sequence += 1
        messages.append(EventMessage(sequence=row.sequence, at=now, event=_happening.validate_python(event)))
    return messages


def list_events(db: Session, run: str, after: int) -> list[tuple[int, str]]:
    """The run's events behind a sequence number: theirs, and their bodies."""
    query = (
        select(RunEventRow.sequence, RunEventRow.body)
        .where(RunEventRow.run == run, RunEventRow.sequence > after)
        .order_by(RunEventRow.sequence)
    )
    return [(sequence, body) for sequence, body in db.execute(query)]


def list_first_runs(db: Session) -> list[RunRow]:
    """The first run of each cell that is not over; Aborted is not over before it is cleared."""
    first: dict[str, RunRow] = {}
    for row in db.scalars(select(RunRow).where(RunRow.state.not_in(FINAL)).order_by(RunRow.id)):
        first.setdefault(row.cell, row)
    return list(first.values())


def find_latest_run(db: Session, cell: str) -> RunRow | None:
    """The cell's run: the first that is not over, else the last; None where it has had none."""
    query = select(RunRow).where(RunRow.cell == cell)
    carried = db.scalar(query.where(RunRow.state.not_in(FINAL)).order_by(RunRow.id).limit(1))
    return carried or db.scalar(query.order_by(RunRow.id.desc()).limit(1))


def may_continue(row: RunRow) -> bool:
    """Whether an ended run has finished steps that a new one need not make again."""
    return row.state in (State.STOPPED, State.ABORTED) and row.result is None and row.finished_steps > 0


def read_plan_sha256(row: RunRow) -> str | None:
    """Of the newest plan that was shown for a run."""
    return None if row.plan is None else PlanHash.model_validate_json(row.plan).sha256


def build_answer(row: RunRow, progress: float = 0.0, eta_s: float | None = None, ends_at: datetime | None = None) -> RunPublic:
    """The run as it leaves the service."""
    state, motion = State(row.state), motion_of(row)
    return RunPublic(
        run=row.id,
        cell=row.cell,
        payload=row.payload,
        saved_payload=row.saved_payload,
        order_id=row.order_id,
        work_order=row.work_order,
        serial_number=row.serial_number,
        order=RunOrder.model_validate_json(row.order),
        state=state,
        job_state=job_state(state, released=row.released, aborted=row.aborted),
        outcome=None if row.outcome is None else RunOutcome(row.outcome),
        commands=list_offered_commands(state),
        released=row.released,
        reason=read_reason(row),
        reason_kind=row.reason_kind,
        lateness=None if row.lateness is None else Lateness.model_validate_json(row.lateness),
        held_since=row.held_since,
        ends_at=ends_at,
        steps=row.steps,
        finished_steps=row.finished_steps,
        may_continue=may_continue(row),
        in_the_way=row.in_the_way,
        progress=1.0 if state is State.COMPLETE else progress,
        eta_s=eta_s,
        sequence=row.sequence,
        requested_by=row.requested_by,
        requested_at=row.requested_at,
        released_by=row.released_by,
        released_at=row.released_at,
        ended_at=row.ended_at,
        plan_sha256=read_plan_sha256(row),
        result=None if row.result is None else summary_of(Result.model_validate_json(row.result)),
        accepted_by=row.accepted_by,
        accepted_at=row.accepted_at,
        continues=None if motion is None else motion.continues,
        diagnosis=None if motion is None else motion.diagnosis,
    )


def refusal(row: RunRow, what: str) -> Conflict:
    """Something that the run's state does not allow, with what it does allow."""
    legal = list_offered_commands(State(row.state))
    if not legal:
        return Conflict("runs-command-impossible", run=row.id, command=what, state=row.state)
    commands = [Message.of("runs-command", command=each) for each in legal]
    return Conflict("runs-command-not-possible", allowed=legal, run=row.id, command=what, state=row.state, commands=commands)


def _state_changed(row: RunRow) -> StateChanged:
    state = State(row.state)
    job = job_state(state, released=row.released, aborted=row.aborted)
    return StateChanged(
        state=state,
        job_state=job,
        outcome=None if row.outcome is None else RunOutcome(row.outcome),
        commands=list_offered_commands(state),
        reason=read_reason(row),
        reason_kind=row.reason_kind,
    )
