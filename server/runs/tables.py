"""What is kept of runs: the run itself, what happened to it in order, who asked for it under which key, who is told of its end."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import ForeignKey, Index, String, Text
from sqlalchemy.orm import Mapped, mapped_column

from server.store.store import Table


class RunRow(Table):
    """One run. `order`, `motion`, `plan` and `result` are JSON (`RunOrder`, `ProposedMotion | RestOfRun`, `RunPlan`,
    `core.estimation.result.Result`)."""

    __tablename__ = "runs"
    __table_args__ = (
        Index(
            "ix_runs_searched", "cell", "id", "payload", "saved_payload", "state", "outcome", "order_id", "work_order", "serial_number",
            "requested_by", "released_by", "accepted_by", "requested_at", "ended_at",
        ),
    )  # fmt: skip

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    """Sorts by the time of its making."""
    cell: Mapped[str] = mapped_column(String(64), index=True)
    payload: Mapped[str | None] = mapped_column(String(64), index=True)
    saved_payload: Mapped[str | None] = mapped_column(String(32), index=True)
    """Identifier in the tool library, also when it is no longer there; None where `payload` is one of cell.toml."""
    known_payload: Mapped[str | None] = mapped_column(Text)
    """JSON (`core.cell.cell.Payload`): what was known of a saved payload when the run was asked for; None where only its box was."""
    order: Mapped[str] = mapped_column("run_order", Text)
    order_id: Mapped[str | None] = mapped_column(String(100), index=True)
    work_order: Mapped[str | None] = mapped_column(String(100), index=True)
    serial_number: Mapped[str | None] = mapped_column(String(100), index=True)
    motion: Mapped[str | None] = mapped_column(Text)
    """None for a whole procedure."""
    state: Mapped[str] = mapped_column(String(16), index=True)
    released: Mapped[bool] = mapped_column(default=False)
    aborted: Mapped[bool] = mapped_column(default=False)
    """The job failed, whatever the machine's state is by now."""
    outcome: Mapped[str | None] = mapped_column(String(16), index=True)
    """How it ended (`server.runs.packml.RunOutcome`); None before that."""
    reason: Mapped[str | None] = mapped_column(Text)
    """JSON (`core.words.message.Message`)."""
    reason_kind: Mapped[str | None] = mapped_column(String(32))
    """Of `reason`: kind of a problem (`server.http.problems`), or one of `server.runs.reason.OWN`. None without a reason."""
    in_the_way: Mapped[str | None] = mapped_column(String(64))
    plan: Mapped[str | None] = mapped_column(Text)
    result: Mapped[str | None] = mapped_column(Text)
    sequence: Mapped[int] = mapped_column(default=0)
    """Of the last event."""
    journaled: Mapped[int] = mapped_column(default=0, server_default="0")
    """Number of the last entry of the run's journal that is here."""
    steps: Mapped[int] = mapped_column(default=0, server_default="0")
    finished_steps: Mapped[int] = mapped_column(default=0, server_default="0")
    lateness: Mapped[str | None] = mapped_column(Text)
    """JSON (`core.errors.Lateness`): what was late, where that put the run on hold or ended it."""
    held_since: Mapped[datetime | None]
    requested_by: Mapped[str] = mapped_column(String(80))
    requested_at: Mapped[datetime]
    released_by: Mapped[str | None] = mapped_column(String(80))
    released_at: Mapped[datetime | None]
    ended_at: Mapped[datetime | None]
    accepted_by: Mapped[str | None] = mapped_column(String(80))
    accepted_at: Mapped[datetime | None]


class RunEventRow(Table):
    """One thing that happened to a run; `body` is JSON (`EventMessage`)."""

    __tablename__ = "run_events"

    run: Mapped[str] = mapped_column(String(32), ForeignKey("runs.id"), primary_key=True)
    sequence: Mapped[int] = mapped_column(primary_key=True, autoincrement=False)
    body: Mapped[str] = mapped_column(Text)


class IdempotencyKey(Table):
    """A request that was answered already, and how."""

    __tablename__ = "idempotency_keys"

    caller: Mapped[str] = mapped_column(String(80), primary_key=True)
    key: Mapped[str] = mapped_column(String(128), primary_key=True)
    body_sha256: Mapped[str] = mapped_column(String(64))
    made: Mapped[str] = mapped_column(String(32))
    made_at: Mapped[datetime]


class ControlFence(Table):
    """How often control of a cell has changed hands; never counts back, also not when the service starts anew."""

    __tablename__ = "control_fences"

    cell: Mapped[str] = mapped_column(String(64), primary_key=True)
    fence: Mapped[int]


class Webhook(Table):
    """Whom to tell when a run has ended."""

    __tablename__ = "webhooks"

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    url: Mapped[str] = mapped_column(String(500))
    secret: Mapped[str] = mapped_column(String(128))
    """Signs the deliveries, so it cannot be kept as a hash."""
    made_by: Mapped[str] = mapped_column(String(80))
    made_at: Mapped[datetime]


class Delivery(Table):
    """One message to one webhook; kept until it is delivered or given up."""

    __tablename__ = "webhook_deliveries"

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    webhook: Mapped[str] = mapped_column(String(32), ForeignKey("webhooks.id", ondelete="CASCADE"), index=True)
    body: Mapped[str] = mapped_column(Text)
    attempts: Mapped[int] = mapped_column(default=0)
    made_at: Mapped[datetime]
    due_at: Mapped[datetime | None] = mapped_column(index=True)
    """None once it is delivered or given up."""
    delivered_at: Mapped[datetime | None]
    last_error: Mapped[str | None] = mapped_column(Text)
    """JSON (`core.words.message.Message`)."""


class JobRow(Table):
    """Work in the background that was asked for. `order`, `told` and `result` are JSON, which `kind` tells how to read."""

    __tablename__ = "jobs"

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    """Sorts by the time of its making."""
    kind: Mapped[str] = mapped_column(String(16), index=True)
    about: Mapped[str | None] = mapped_column(String(64), index=True)
    """The run or the cell that it is about."""
    order: Mapped[str] = mapped_column("job_order", Text)
    state: Mapped[str] = mapped_column(String(16), index=True)
    told: Mapped[str | None] = mapped_column(Text)
    """What may be known before it is done."""
    result: Mapped[str | None] = mapped_column(Text)
    reason: Mapped[str | None] = mapped_column(Text)
    """JSON (`core.words.message.Message`)."""
    reason_kind: Mapped[str | None] = mapped_column(String(32))
    """Of `reason`: kind of a problem (`server.http.problems`), or one of `server.runs.reason.OWN`. None without a reason."""
    requested_by: Mapped[str] = mapped_column(String(80))
    requested_at: Mapped[datetime]
    ended_at: Mapped[datetime | None]
