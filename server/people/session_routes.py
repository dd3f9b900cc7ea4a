"""Signing in and out in a browser."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Header, Response
from pydantic import Field
from sqlalchemy import delete

from server.http.dependencies import ClientAddressDep, MetricsDep, NowDep, SettingsDep, StoreDep
from server.http.errors import NotAllowed, NotSignedIn
from server.http.openapi import COOKIE
from server.http.schemas import Answer, Name, NewPassword, Password, RequestBody
from server.people import accounts, audit, login_limit
from server.people.accounts import Account, SignIn
from server.people.auth import CallerDep, RecentCallersDep
from server.people.roles import Role

router = APIRouter(prefix="/api/session", tags=["session"])


class Credentials(RequestBody):
    """Who signs in."""

    name: Name = Field(description="Name of the account.", examples=["anna"])
    password: Password = Field(description="Its password.", examples=["a long sentence of your own"])


class PasswordUpdate(RequestBody):
    """The password until now, and from now on."""

    password: Password = Field(description="The password until now.", examples=["a long sentence of your own"])
    new_password: NewPassword = Field(description="The password from now on, at least 12 characters.", examples=["another long sentence"])


class SessionPublic(Answer):
    """Who is asking; a browser sends the CSRF token back with every request that changes something."""

    name: str = Field(description="Name of the account or key.", examples=["anna"])
    roles: list[Role] = Field(description="What it may do.", examples=[["operator"]])
    csrf_token: str | None = Field(
        description="Sent back as `X-CSRF-Token` with every request of a browser that changes something; null for a key.",
        examples=["pX3s9uQ0vEo"],
    )


@router.post("")
def sign_in(
    body: Credentials,
    response: Response,
    store: StoreDep,
    settings: SettingsDep,
    metrics: MetricsDep,
    address: ClientAddressDep,
    now: NowDep,
    user_agent: Annotated[str | None, Header(description="What signs in, as it names itself.", examples=["Mozilla/5.0"])] = None,
) -> SessionPublic:
    """Signs a browser in; the answer sets its cookie. Failures make the next try wait."""
    name = body.name
    with store.read() as db:
        login_limit.check_limit(db, name, address, now)
        account = db.get(Account, name)
    if not accounts.password_is_right(account, body.password.get_secret_value()) or account is None:
        with store.write() as db:
            login_limit.count_failure(db, name, address, now)
            audit.record(db, "nobody", "session.refuse", {"account": name, "address": address}, now=now)
        metrics.sign_ins.labels("refused").inc()
        raise NotSignedIn("people-sign-in-refused")
    with store.write() as db:
        accounts.sweep_sessions(db, now - settings.session_lasts, now - settings.idle_lasts)
        login_limit.forget_failures(db, name, address)
        token, session = accounts.open_session(db, account, address, now, user_agent)
        audit.record(db, f"account:{name}", "session.open", {"address": address}, now=now)
    metrics.sign_ins.labels("accepted").inc()
    secure = settings.secure_cookies
    response.set_cookie(
        COOKIE, token, max_age=round(settings.session_lasts.total_seconds()), httponly=True, samesite="strict", secure=secure
    )
    return SessionPublic(name=name, roles=sorted(account.roles), csrf_token=session.csrf_token)


@router.get("")
def read_session(caller: CallerDep) -> SessionPublic:
    """Who is asking, with what authority."""
    return SessionPublic(name=caller.name, roles=sorted(caller.roles), csrf_token=caller.csrf_token)


@router.delete("", status_code=204)
def sign_out(response: Response, caller: CallerDep, store: StoreDep, recent_callers: RecentCallersDep, now: NowDep) -> None:
    """Ends this browser's session."""
    with store.write() as db:
        db.execute(delete(SignIn).where(SignIn.token_hash == caller.session))
        audit.record(db, caller.who, "session.close", now=now)
    recent_callers.forget(caller.who)
    response.delete_cookie(COOKIE)


@router.put("/password", status_code=204)
def change_password(
    body: PasswordUpdate, caller: CallerDep, store: StoreDep, recent_callers: RecentCallersDep, now: NowDep, address: ClientAddressDep
) -> None:
    """Changes one's own password and signs out everywhere else."""
    if caller.session is None:
        raise NotAllowed("people-key-without-password")
    with store.read() as db:
        login_limit.check_limit(db, caller.name, address, now)
        account = db.get(Account, caller.name)
    if not accounts.password_is_right(account, body.password.get_secret_value()):
        with store.write() as db:
            login_limit.count_failure(db, caller.name, address, now)
        raise NotAllowed("people-password-wrong")
    new_hash = accounts.hash_password(body.new_password.get_secret_value())
    with store.write() as db:
        accounts.update_account(db, caller.name, password_hash=new_hash, staying=caller.session)
        audit.record(db, caller.who, "account.password", {"account": caller.name}, now=now)
    recent_callers.forget(caller.who)
