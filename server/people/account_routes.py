"""Who may sign in."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Response
from pydantic import Field
from sqlalchemy import select

from server.http.dependencies import NamePath, NowDep, StoreDep
from server.http.schemas import Answer, Name, NewPassword, RequestBody
from server.people import accounts, audit
from server.people.accounts import Account
from server.people.audit import Detail
from server.people.auth import CallerDep, RecentCallersDep
from server.people.roles import Role

router = APIRouter(prefix="/api/accounts", tags=["accounts"])

Roles = Annotated[frozenset[Role], Field(min_length=1)]


class NewAccount(RequestBody):
    """Somebody who is to sign in."""

    name: Name
    password: NewPassword
    roles: Roles


class AccountChange(RequestBody):
    """What is to change; the rest stays."""

    password: NewPassword | None = None
    roles: Roles | None = None
    disabled: bool | None = None


class AccountShown(Answer):
    """Somebody who signs in."""

    name: str
    roles: list[Role]
    disabled: bool
    created_at: datetime


def _answer(account: Account) -> AccountShown:
    return AccountShown(name=account.name, roles=sorted(account.roles), disabled=account.disabled, created_at=account.created_at)


@router.get("")
def list_accounts(store: StoreDep) -> list[AccountShown]:
    """All accounts."""
    with store.read() as db:
        return [_answer(account) for account in db.scalars(select(Account).order_by(Account.name))]


@router.post(
    "",
    status_code=201,
    responses={201: {"links": {"change": {"operationId": "change_account", "parameters": {"account": "$response.body#/name"}}}}},
)
def create_account(body: NewAccount, response: Response, caller: CallerDep, store: StoreDep, now: NowDep) -> AccountShown:
    """Adds an account."""
    password_hash = accounts.hash_password(body.password.get_secret_value())
    with store.write() as db:
        account = accounts.add_account(db, body.name, password_hash, body.roles, now)
        audit.record(db, caller.who, "account.create", {"account": body.name, "roles": account.roles_text}, now=now)
    response.headers["Location"] = f"/api/accounts/{body.name}"
    return _answer(account)


@router.patch("/{account}")
def change_account(
    account: NamePath,
    body: AccountChange,
    caller: CallerDep,
    store: StoreDep,
    recent_callers: RecentCallersDep,
    now: NowDep,
) -> AccountShown:
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
