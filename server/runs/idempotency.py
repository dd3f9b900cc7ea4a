"""Requests that may come twice and make one thing: what a key has made is kept with what it made."""

from __future__ import annotations

from datetime import datetime
from hashlib import sha256

from sqlalchemy.orm import Session

from server.http.errors import Unprocessable
from server.runs.tables import IdempotencyKey


def remember_request(db: Session, who: str, key: str, body: bytes, made: str, now: datetime) -> None:
    """Remembers what a request made, in the transaction that makes it."""
    db.add(IdempotencyKey(caller=who, key=key, body_sha256=sha256(body).hexdigest(), made=made, made_at=now))


def recall_request(db: Session, who: str, key: str, body: bytes) -> str | None:
    """What the same request has made already.

    Raises:
        Unprocessable: the key came with another body.
    """
    row = db.get(IdempotencyKey, (who, key))
    if row is None:
        return None
    if row.body_sha256 != sha256(body).hexdigest():
        raise Unprocessable("request-key-reused", key=key[:60])
    return row.made
