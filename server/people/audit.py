"""What was done, by whom, in order: appended and never changed; each entry carries the hash of the one before it.

A change to any entry breaks the chain from there on. What a chain cannot show is an end that was cut off, so the hash of each entry also
goes to the service's log, and `heft audit verify --expect HASH` asks whether the chain still contains it.
"""

from __future__ import annotations

import hashlib
import json
import logging
from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC, datetime

from pydantic import BaseModel, ConfigDict
from sqlalchemy import BigInteger, String, Text, event, select, text
from sqlalchemy.orm import Mapped, Session, mapped_column

from core.errors import BadInput
from core.words.message import Message
from server.store.store import Table
from server.telemetry.request_context import request_id

log = logging.getLogger("heft.audit")

START = "0" * 64
"""What stands before the first entry."""
LOG = Message.of("people-audit-log")

Detail = Mapping[str, str | int | float | bool | None]


class Deed(BaseModel):
    """Something that was done, before it stands in the log."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    who: str
    action: str
    detail: dict[str, str | int | float | bool | None]
    at: datetime
    request: str


def make_deed(who: str, action: str, detail: Detail, *, now: datetime) -> Deed:
    """What the request at hand has done; arguments as for `record`."""
    return Deed(who=who, action=action, detail=dict(detail), at=now, request=request_id.get())


class AuditEntry(Table):
    """One thing that was done or refused."""

    __tablename__ = "audit"

    number: Mapped[int] = mapped_column(BigInteger, primary_key=True, autoincrement=False)
    at: Mapped[str] = mapped_column(String(32))
    who: Mapped[str] = mapped_column(String(80))
    action: Mapped[str] = mapped_column(String(80), index=True)
    detail: Mapped[str] = mapped_column(Text)
    request: Mapped[str] = mapped_column(String(64))
    previous_hash: Mapped[str] = mapped_column(String(64))
    hash: Mapped[str] = mapped_column(String(64), unique=True)


def record(db: Session, who: str, action: str, detail: Detail | None = None, *, now: datetime | None = None) -> AuditEntry:
    """Appends what the request at hand has done; arguments as for `record_deed`."""
    return record_deed(db, make_deed(who, action, detail or {}, now=now or datetime.now(UTC)))


def record_deed(db: Session, done: Deed) -> AuditEntry:
    """Appends to the log, in the transaction of what it records: both are kept or neither.

    Args:
        done: `who` is an account or a key, for example "account:anna", "key:mes-line-3", "service"; `action` noun and verb, for example
            "session.open", "run.release", "cell.replace"; `detail` what else is worth knowing, no secrets.
    """
    if db.get_bind().dialect.name == "postgresql":
        db.execute(text("LOCK TABLE audit IN EXCLUSIVE MODE"))  # one appends at a time; SQLite's writers do so anyway
    last = db.scalar(select(AuditEntry).order_by(AuditEntry.number.desc()).limit(1))
    entry = AuditEntry(
        number=1 if last is None else last.number + 1,
        at=done.at.astimezone(UTC).isoformat(timespec="microseconds"),
        who=done.who[:80],
        action=done.action,
        detail=json.dumps(done.detail, sort_keys=True, ensure_ascii=False, separators=(",", ":")),
        request=done.request,
        previous_hash=START if last is None else last.hash,
    )
    entry.hash = entry_hash(entry)
    db.add(entry)
    db.flush()
    line = {"audit_number": entry.number, "audit_action": done.action, "audit_who": entry.who, "audit_hash": entry.hash}
    event.listen(db, "after_commit", lambda _session: log.info("audit", extra=line), once=True)  # what was undone never was in the chain
    return entry


def entry_hash(entry: AuditEntry) -> str:
    """SHA-256 over the previous hash and all that the entry says."""
    said = [entry.number, entry.at, entry.who, entry.action, entry.detail, entry.request, entry.previous_hash]
    return hashlib.sha256(json.dumps(said, ensure_ascii=False).encode()).hexdigest()


def entries(db: Session) -> Iterator[AuditEntry]:
    """All, oldest first, some at a time."""
    yield from db.scalars(select(AuditEntry).order_by(AuditEntry.number).execution_options(yield_per=500))


def verify_chain(chain: Iterable[AuditEntry]) -> tuple[int, str, BadInput | None]:
    """Walks the chain.

    Returns:
        How many entries hold, the hash of the last of them, and what is wrong with the one after it; None where all hold.
    """
    count, previous = 0, START
    for entry in chain:
        if entry.number != count + 1:
            return count, previous, BadInput(LOG, "people-audit-entry-missing", number=count + 1, next_number=entry.number)
        if entry.previous_hash != previous:
            return count, previous, BadInput(LOG, "people-audit-entry-unlinked", number=entry.number, last_number=count)
        if entry.hash != entry_hash(entry):
            return count, previous, BadInput(LOG, "people-audit-entry-changed", number=entry.number, action=entry.action)
        count, previous = count + 1, entry.hash
    return count, previous, None
