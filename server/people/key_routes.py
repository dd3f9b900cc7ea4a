"""Keys for machines."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Response
from pydantic import Field
from sqlalchemy import select

from server.http.dependencies import NowDep, StoreDep
from server.http.parameters import KeyPath
from server.http.schemas import Answer, Name, RequestBody
from server.people import accounts, audit
from server.people.accounts import ApiKey
from server.people.auth import CallerDep, RecentCallersDep
from server.people.roles import MACHINE_ROLES, Role

router = APIRouter(prefix="/api/keys", tags=["keys"])


class KeyCreate(RequestBody):
    """A machine that is to be let in."""

    name: Name = Field(description="Name of the machine.", examples=["line-3"])
    role: Annotated[Role, Field(json_schema_extra={"enum": sorted(MACHINE_ROLES)})] = Field(
        description="What it may do; a machine is never operator or admin."
    )
    valid_days: Annotated[float, Field(gt=0, le=3660)] | None = Field(
        default=None, description="Days until it ends; without end where null.", examples=[365.0]
    )


class KeyPublic(Answer):
    """A machine's key; the key itself is not kept."""

    name: str = Field(description="Name of the machine.", examples=["line-3"])
    prefix: str = Field(description="First characters of the key, to recognise it by.", examples=["heft_a1b2"])
    role: Role = Field(description="What it may do.")
    created_by: str = Field(description="Who made it.", examples=["account:admin"])
    created_at: datetime = Field(description="When it was made.", examples=["2026-03-01T07:00:00Z"])
    expires_at: datetime | None = Field(description="When it ends; null where it does not.", examples=["2027-03-01T07:00:00Z"])
    used_at: datetime | None = Field(
        description="When it was shown last, to the minute; null for one that nothing has shown yet.", examples=["2026-03-01T09:12:00Z"]
    )


class KeyIssued(KeyPublic):
    """A new key; this is the only time that it is shown."""

    key: str = Field(description="The key itself. This is the only time that it is shown.", examples=["heft_a1b2c3d4e5f6..."])


@router.get("")
def list_keys(store: StoreDep) -> list[KeyPublic]:
    """All keys."""
    with store.read() as db:
        return [KeyPublic.model_validate(key) for key in db.scalars(select(ApiKey).order_by(ApiKey.name))]


@router.post(
    "",
    status_code=201,
    responses={201: {"links": {"revoke": {"operationId": "revoke_key", "parameters": {"key": "$response.body#/name"}}}}},
)
def create_key(body: KeyCreate, response: Response, caller: CallerDep, store: StoreDep, now: NowDep) -> KeyIssued:
    """Makes a key and shows it once."""
    with store.write() as db:
        key, row = accounts.add_key(db, body.name, body.role, caller.who, now, body.valid_days)
        audit.record(db, caller.who, "key.create", {"key": body.name, "role": body.role.value, "prefix": row.prefix}, now=now)
    response.headers["Location"] = f"/api/keys/{body.name}"
    return KeyIssued(**KeyPublic.model_validate(row).model_dump(), key=key)


@router.delete("/{key}", status_code=204)
def revoke_key(key: KeyPath, caller: CallerDep, store: StoreDep, recent_callers: RecentCallersDep, now: NowDep) -> None:
    """Makes a key worthless, at once."""
    with store.write() as db:
        accounts.delete_key(db, key)
        audit.record(db, caller.who, "key.revoke", {"key": key}, now=now)
    recent_callers.forget(f"key:{key}")
