"""The audit log, to be read."""

from __future__ import annotations

import json
from typing import Annotated, Any

from fastapi import APIRouter, Query
from sqlalchemy import select

from server.http.dependencies import StoreDep
from server.http.schemas import Answer
from server.people.audit import AuditEntry

router = APIRouter(prefix="/api/audit", tags=["audit"])


class AuditEntryShown(Answer):
    """One thing that was done or refused; `hash` covers it and, by `previous_hash`, all before it."""

    number: int
    at: str
    who: str
    action: str
    detail: dict[str, Any]
    request: str
    previous_hash: str
    hash: str


@router.get("")
def list_audit(
    store: StoreDep, before: Annotated[int, Query(ge=1, le=2**53)] = 2**53, limit: Annotated[int, Query(ge=1, le=1000)] = 100
) -> list[AuditEntryShown]:
    """The latest entries, newest first; `before` a number, for those further back."""
    with store.read() as db:
        rows = db.scalars(select(AuditEntry).where(AuditEntry.number < before).order_by(AuditEntry.number.desc()).limit(limit))
        return [_answer(row) for row in rows]


def _answer(row: AuditEntry) -> AuditEntryShown:
    return AuditEntryShown(
        number=row.number,
        at=row.at,
        who=row.who,
        action=row.action,
        detail=json.loads(row.detail),
        request=row.request,
        previous_hash=row.previous_hash,
        hash=row.hash,
    )
