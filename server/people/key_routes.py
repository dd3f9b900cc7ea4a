"""Keys for machines."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Response
from pydantic import Field
from sqlalchemy import select

from server.http.dependencies import NamePath, NowDep, StoreDep
from server.http.schemas import Answer, Name, RequestBody
from server.people import accounts, audit
from server.people.accounts import ApiKey
from server.people.auth import CallerDep, RecentCallersDep
from server.people.roles import MACHINE_ROLES, Role

router = APIRouter(prefix="/api/keys", tags=["keys"])


class NewKey(RequestBody):
    """A machine that is to be let in."""

    name: Name
    role: Annotated[Role, Field(json_schema_extra={"enum": sorted(MACHINE_ROLES)})]
    valid_days: Annotated[float, Field(gt=0, le=3660)] | None = None
    """Without end where absent."""


class KeyShown(Answer):
    """A machine's key; the key itself is not kept."""

    name: str
    prefix: str
    role: Role
    created_by: str
    created_at: datetime
    expires_at: datetime | None


class KeyMade(KeyShown):
    """A new key; this is the only time that it is shown."""

    key: str


@router.get("")
def list_keys(store: StoreDep) -> list[KeyShown]:
    """All keys."""
    with store.read() as db:
        return [KeyShown.model_validate(key) for key in db.scalars(select(ApiKey).order_by(ApiKey.name))]


@router.post(
    "",
    status_code=201,
    responses={201: {"links": {"revoke": {"operationId": "revoke_key", "parameters": {"key": "$response.body#/name"}}}}},
)
def create_key(body: NewKey, response: Response, caller: CallerDep, store: StoreDep, now: NowDep) -> KeyMade:
    """Makes a key and shows it once."""
    with store.write() as db:
        key, row = accounts.add_key(db, body.name, body.role, caller.who, now, body.valid_days)
        audit.record(db, caller.who, "key.create", {"key": body.name, "role": body.role.value, "prefix": row.prefix}, now=now)
    response.headers["Location"] = f"/api/keys/{body.name}"
    return KeyMade(**KeyShown.model_validate(row).model_dump(), key=key)


@router.delete("/{key}", status_code=204)
def revoke_key(key: NamePath, caller: CallerDep, store: StoreDep, recent_callers: RecentCallersDep, now: NowDep) -> None:
    """Makes a key worthless, at once."""
    with store.write() as db:
        accounts.delete_key(db, key)
        audit.record(db, caller.who, "key.revoke", {"key": key}, now=now)
    recent_callers.forget(f"key:{key}")
