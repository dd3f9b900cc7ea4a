"""The audit log, to be read, searched and verified."""

from __future__ import annotations

import json
from datetime import UTC
from typing import Annotated, Any

from fastapi import APIRouter, Query
from pydantic import Field, StringConstraints
from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from core.errors import BadInput
from core.words.message import Message
from server.http.dependencies import StoreDep
from server.http.schemas import Answer, Moment, RequestBody
from server.people import audit
from server.people.audit import AuditEntry

router = APIRouter(prefix="/api/audit", tags=["audit"])

Text = Annotated[str, StringConstraints(pattern=r"^[^\x00-\x1f]{1,80}$")]


class AuditEntryPublic(Answer):
    """One thing that was done or refused; `hash` covers it and, by `previous_hash`, all before it."""

    number: int = Field(description="Number in the log, from 1 without gaps.", examples=[1042])
    at: str = Field(description="When it was done, UTC.", examples=["2026-03-01T08:00:00.120000+00:00"])
    who: str = Field(description="Who did it: an account, a key, or the service.", examples=["account:anna"])
    action: str = Field(description="What was done, noun and verb.", examples=["run.release"])
    detail: dict[str, Any] = Field(description="What else is worth knowing.", examples=[{"run": "019ab1c2d3e44f1c2a9be7"}])
    request: str = Field(description="Identifier of the request that did it.", examples=["4f1c2a9be7d34a06"])
    previous_hash: str = Field(
        description="Hash of the entry before it.", examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"]
    )
    hash: str = Field(
        description="SHA-256 over this entry and `previous_hash`, hexadecimal; by that, over all before it.",
        examples=["60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752"],
    )


class AuditQuery(RequestBody):
    """Which entries; all that is given has to hold."""

    before: int = Field(2**53, ge=1, le=2**53, description="Entries with smaller numbers: those further back.", examples=[1042])
    limit: int = Field(100, ge=1, le=1000, description="How many at most.", examples=[100])
    who: Text | None = Field(
        None, description="Who did it, as entries name them: `account:anna`, `key:line-3`, `service`.", examples=["account:anna"]
    )
    action: Text | None = Field(None, description="What was done: `run.release`, or its noun alone, `run`.", examples=["run.release"])
    mentions: Text | None = Field(None, description="Text that the entry's detail contains, such as a run's id.", examples=["ur5e_line"])
    since: Moment | None = Field(None, description="Not before this time.", examples=["2026-03-01T08:00:00Z"])
    until: Moment | None = Field(None, description="Before this time.", examples=["2026-03-02T08:00:00Z"])

    def conditions(self) -> list[ColumnElement[bool]]:
        """As the store is asked."""
        found: list[ColumnElement[bool]] = [AuditEntry.number < self.before]
        if self.who is not None:
            found.append(AuditEntry.who == self.who)
        if self.action is not None:
            found.append((AuditEntry.action == self.action) | AuditEntry.action.startswith(f"{self.action}.", autoescape=True))
        if self.mentions is not None:
            found.append(AuditEntry.detail.contains(self.mentions, autoescape=True))
        if self.since is not None:
            found.append(AuditEntry.at >= self.since.astimezone(UTC).isoformat(timespec="microseconds"))
        if self.until is not None:
            found.append(AuditEntry.at < self.until.astimezone(UTC).isoformat(timespec="microseconds"))
        return found


class AuditNames(Answer):
    """Whom and what the log speaks of, in order."""

    who: list[str] = Field(description="Everybody who has done something.", examples=[["account:anna", "key:line-3", "service"]])
    actions: list[str] = Field(description="Everything that was done.", examples=[["run.create", "run.release"]])


class AuditVerified(Answer):
    """Whether nothing in the log was changed, removed or put in between."""

    unbroken: bool = Field(description="Whether the chain holds to its end.")
    entries: int = Field(description="How many entries hold, from the first on.", examples=[1042])
    hash: str = Field(
        description="Hash of the last of them; keep it elsewhere, and ask for it as `expect` later.",
        examples=["60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752"],
    )
    flaw: Message | None = Field(description="What is wrong with the entry after them; null where all hold.")


@router.get("")
def list_audit(store: StoreDep, query: Annotated[AuditQuery, Query()]) -> list[AuditEntryPublic]:
    """The latest entries that fit, newest first."""
    with store.read() as db:
        rows = db.scalars(select(AuditEntry).where(*query.conditions()).order_by(AuditEntry.number.desc()).limit(query.limit))
        return [show_entry(row) for row in rows]


@router.get("/names")
def list_audit_names(store: StoreDep) -> AuditNames:
    """Who and what can be searched for."""
    with store.read() as db:
        who, actions = (sorted(db.scalars(select(column).distinct())) for column in (AuditEntry.who, AuditEntry.action))
    return AuditNames(who=who, actions=actions)


@router.get("/verification")
def verify_audit_log(
    store: StoreDep,
    expect: Annotated[
        str | None,
        Query(
            pattern="^[0-9a-f]{64}$",
            description="A hash seen earlier, which the chain must still contain.",
            examples=["60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752"],
        ),
    ] = None,
) -> AuditVerified:
    """Walks the whole chain, as `heft audit verify` does."""
    with store.read() as db:
        return verify_entries(db, expect)


def verify_entries(db: Session, expect: str | None = None) -> AuditVerified:
    """Walks the chain, and asks whether it contains a hash."""
    count, last, flaw = audit.verify_chain(audit.entries(db))
    if flaw is None and expect is not None and db.scalar(select(AuditEntry.number).where(AuditEntry.hash == expect)) is None:
        flaw = BadInput(audit.LOG, "people-audit-hash-missing", entries=count, hash=expect)
    return AuditVerified(unbroken=flaw is None, entries=count, hash=last, flaw=None if flaw is None else flaw.message)


def show_entry(row: AuditEntry) -> AuditEntryPublic:
    """An entry as it is told."""
    return AuditEntryPublic(
        number=row.number,
        at=row.at,
        who=row.who,
        action=row.action,
        detail=json.loads(row.detail),
        request=row.request,
        previous_hash=row.previous_hash,
        hash=row.hash,
    )
