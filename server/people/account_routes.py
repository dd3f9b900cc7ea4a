"""Who may sign in."""

from __future__ import annotations

from collections import Counter
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Response
from pydantic import Field
from sqlalchemy import select

from server.http.dependencies import NowDep, SettingsDep, StoreDep
from server.http.parameters import AccountPath
from server.http.schemas import Answer, Name, NewPassword, RequestBody
from server.people import accounts, audit
from server.people.accounts import Account
from server.people.audit import Detail
from server.people.auth import CallerDep, RecentCallersDep
from server.people.roles import Role

router = APIRouter(prefix="/api/accounts", tags=["accounts"])

Roles = Annotated[frozenset[Role], Field(min_length=1)]


class AccountCreate(RequestBody):
    """Somebody who is to sign in."""

    name: Name = Field(description="With which somebody signs in.", examples=["anna"])
    password: NewPassword = Field(description="At least 12 characters.", examples=["a long sentence of your own"])
    roles: Roles = Field(description="What they may do.", examples=[["operator"]])


class AccountUpdate(RequestBody):
    """What is to change; the rest stays."""

    password: NewPassword | None = Field(
        default=None, description="A new one, at least 12 characters; stays where null.", examples=["another long sentence"]
    )
    roles: Roles | None = Field(
        default=None, description="What they may do from now on; stays where null.", examples=[["operator", "engineer"]]
    )
    disabled: bool | None = Field(default=None, description="Whether signing in is refused from now on; stays where null.")


class AccountPublic(Answer):
    """Somebody who signs in."""

    name: str = Field(description="With which somebody signs in.", examples=["anna"])
    roles: list[Role] = Field(description="What they may do.", examples=[["operator"]])
    disabled: bool = Field(description="Whether signing in is refused.")
    created_at: datetime = Field(description="When it was made.", examples=["2026-03-01T07:00:00Z"])
    sessions: int = Field(description="Browsers that the account is signed in with now.", examples=[1])


def _answer(account: Account, sessions: int = 0) -> AccountPublic:
    return AccountPublic(
        name=account.name, roles=sorted(account.roles), disabled=account.disabled, created_at=account.created_at, sessions=sessions
    )


@router.get("")
def list_accounts(store: StoreDep, settings: SettingsDep, now: NowDep) -> list[AccountPublic]:
    """All accounts."""
    with store.read() as db:
        signed_in = Counter(each.account for each in accounts.list_sessions(db, now - settings.session_lasts, now - settings.idle_lasts))
        return [_answer(account, signed_in[account.name]) for account in db.scalars(select(Account).order_by(Account.name))]


@router.post(
    "",
    status_code=201,
    responses={201: {"links": {"change": {"operationId": "change_account", "parameters": {"account": "$response.body#/name"}}}}},
)
def create_account(body: AccountCreate, response: Response, caller: CallerDep, store: StoreDep, now: NowDep) -> AccountPublic:
    """Adds an account."""
    password_hash = accounts.hash_password(body.password.get_secret_value())
    with store.write() as db:
        account = accounts.add_account(db, body.name, password_hash, body.roles, now)
        audit.record(db, caller.who, "account.create", {"account": body.name, "roles": account.roles_text}, now=now)
    response.headers["Location"] = f"/api/accounts/{body.name}"
    return _answer(account)


@router.patch("/{account}")
def change_account(
    account: AccountPath,
    body: AccountUpdate,
    caller: CallerDep,
    store: StoreDep,
    recent_callers: RecentCallersDep,
    now: NowDep,
) -> AccountPublic:
    """Changes an account and signs it out everywhere."""
    password_hash = None if body.password is None else accounts.hash_password(body.password.get_secret_value())
    with store.write() as db:
        changed = accounts.update_account(db, account, password_hash=password_hash, roles=body.roles, disabled=body.disabled)
        said: Detail = {
            "account": account,
            "roles": changed.roles_text,
            "disabled": changed.disabled,
            "password": password_hash is not None,
        }
        audit.record(db, caller.who, "account.change", said, now=now)
    recent_callers.forget(f"account:{account}")
    return _answer(changed)
