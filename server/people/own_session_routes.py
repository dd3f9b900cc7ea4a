"""The browsers that somebody is signed in with: listed for themselves, and ended from afar."""

from __future__ import annotations

from datetime import datetime

from fastapi import APIRouter
from pydantic import Field

from server.http.dependencies import NowDep, SettingsDep, StoreDep
from server.http.errors import NotFound
from server.http.parameters import SessionPath
from server.http.schemas import Answer
from server.people import accounts, audit
from server.people.auth import CallerDep, RecentCallersDep

router = APIRouter(prefix="/api/sessions", tags=["session"])


class OwnSession(Answer):
    """A browser that the caller is signed in with."""

    id: str = Field(description="Names the session; it opens nothing.", examples=["019ab1c2d3e44f1c2a9be7"])
    browser: str | None = Field(description="As the browser names itself; null where it does not.", examples=["Firefox 145 on Linux"])
    address: str = Field(description="That it signed in from.", examples=["10.20.0.31"])
    created_at: datetime = Field(description="When it signed in.", examples=["2026-03-01T06:00:00Z"])
    used_at: datetime = Field(description="When it was used last, to the minute.", examples=["2026-03-01T08:00:00Z"])
    current: bool = Field(description="Whether it is the one that asks.")


@router.get("")
def list_own_sessions(caller: CallerDep, store: StoreDep, settings: SettingsDep, now: NowDep) -> list[OwnSession]:
    """The caller's own, the one used last first; a machine's key has none."""
    if caller.session is None:
        return []
    with store.read() as db:
        rows = accounts.list_sessions(db, now - settings.session_lasts, now - settings.idle_lasts)
    return [
        OwnSession(
            id=row.id,
            browser=row.browser,
            address=row.address,
            created_at=row.created_at,
            used_at=row.used_at,
            current=row.token_hash == caller.session,
        )
        for row in rows
        if row.account == caller.name
    ]


@router.delete("", status_code=204)
def end_other_sessions(caller: CallerDep, store: StoreDep, recent_callers: RecentCallersDep, now: NowDep) -> None:
    """Signs the caller out everywhere else."""
    if caller.session is None:
        return
    with store.write() as db:
        accounts.end_sessions(db, caller.name, staying=caller.session)
        audit.record(db, caller.who, "session.end", {"session": "others"}, now=now)
    recent_callers.forget(caller.who)


@router.delete("/{session}", status_code=204)
def end_own_session(session: SessionPath, caller: CallerDep, store: StoreDep, recent_callers: RecentCallersDep, now: NowDep) -> None:
    """Signs the caller out in one browser."""
    if caller.session is None:
        raise NotFound("people-session-unknown", session=session[:80])
    with store.write() as db:
        accounts.end_session(db, caller.name, session)
        audit.record(db, caller.who, "session.end", {"session": session}, now=now)
    recent_callers.forget(caller.who)
