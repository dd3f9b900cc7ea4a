"""Signing in and out in a browser."""

from __future__ import annotations

from datetime import timedelta

from fastapi import APIRouter, Response
from sqlalchemy import delete

from server import accounts, audit, login_limit
from server.accounts import Account, SignIn
from server.auth import COOKIE
from server.dependencies import Address, Asking, Here, Now
from server.errors import NotAllowed, NotSignedIn
from server.roles import Role
from server.schemas import Answer, Body, Name, NewPassword, Password

router = APIRouter(prefix="/api/session", tags=["session"])


class Credentials(Body):
    """Who signs in."""

    name: Name
    password: Password


class PasswordChange(Body):
    """The password until now, and from now on."""

    password: Password
    new_password: NewPassword


class Session(Answer):
    """Who is asking; a browser sends the CSRF token back with every request that changes something."""

    name: str
    roles: list[Role]
    csrf_token: str | None


@router.post("")
def sign_in(credentials: Credentials, response: Response, here: Here, address: Address, now: Now) -> Session:
    """Signs a browser in; the answer sets its cookie. Failures make the next try wait."""
    name = credentials.name
    with here.store.read() as db:
        login_limit.check(db, name, address, now)
        account = db.get(Account, name)
    if not accounts.password_is_right(account, credentials.password.get_secret_value()) or account is None:
        with here.store.write() as db:
            login_limit.failed(db, name, address, now)
            audit.record(db, "nobody", "session.refuse", {"account": name, "address": address}, now=now)
        here.metrics.sign_ins.labels("refused").inc()
        raise NotSignedIn("name or password: not right; try again or ask whoever keeps the accounts")
    hours = timedelta(hours=here.settings.session_hours)
    with here.store.write() as db:
        accounts.sweep_sessions(db, now - hours, now - timedelta(minutes=here.settings.idle_minutes))
        login_limit.succeeded(db, name, address)
        token, session = accounts.open_session(db, account, address, now)
        audit.record(db, f"account:{name}", "session.open", {"address": address}, now=now)
    here.metrics.sign_ins.labels("accepted").inc()
    secure = here.settings.secure_cookies
    response.set_cookie(COOKIE, token, max_age=round(hours.total_seconds()), httponly=True, samesite="strict", secure=secure)
    return Session(name=name, roles=sorted(account.roles), csrf_token=session.csrf_token)


@router.get("")
def read_session(asking: Asking) -> Session:
    """Who is asking, with what authority."""
    return Session(name=asking.name, roles=sorted(asking.roles), csrf_token=asking.csrf_token)


@router.delete("", status_code=204)
def sign_out(response: Response, asking: Asking, here: Here, now: Now) -> None:
    """Ends this browser's session."""
    with here.store.write() as db:
        db.execute(delete(SignIn).where(SignIn.token_hash == asking.session))
        audit.record(db, asking.who, "session.close", now=now)
    here.recent_callers.forget(asking.who)
    response.delete_cookie(COOKIE)


@router.put("/password", status_code=204)
def change_password(change: PasswordChange, asking: Asking, here: Here, now: Now, address: Address) -> None:
    """Changes one's own password and signs out everywhere."""
    if asking.session is None:
        raise NotAllowed("password: a key has none; only an account changes its password")
    with here.store.read() as db:
        login_limit.check(db, asking.name, address, now)
        account = db.get(Account, asking.name)
    if not accounts.password_is_right(account, change.password.get_secret_value()):
        with here.store.write() as db:
            login_limit.failed(db, asking.name, address, now)
        raise NotAllowed("password: not the one until now")
    new_hash = accounts.hashed(change.new_password.get_secret_value())
    with here.store.write() as db:
        accounts.change_account(db, asking.name, password_hash=new_hash)
        audit.record(db, asking.who, "account.password", {"account": asking.name}, now=now)
    here.recent_callers.forget(asking.who)
