"""The door that every request and websocket goes through first."""

from __future__ import annotations

import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Annotated

from sqlalchemy import update
from sqlalchemy.exc import SQLAlchemyError
from starlette.requests import HTTPConnection

from server.http.dependencies import depend_on
from server.http.errors import NotAllowed
from server.people import audit
from server.people.accounts import ApiKey, SignIn
from server.people.auth import NOBODY, Caller, RecentCallers, check_authority, check_origin, identify_caller
from server.people.authority import ANYBODY, AUTHORITY, SIGNED_IN
from server.settings import Settings
from server.store.store import Store

log = logging.getLogger("heft.auth")


def endpoint(connection: HTTPConnection) -> str:
    """As the table of authority names it, "PUT /api/cells/{cell}" or "WS /api/runs/{run}/live"."""
    method = "WS" if connection.scope["type"] == "websocket" else connection.scope["method"]
    return f"{method} {connection.scope['route'].path}"


@dataclass(frozen=True)
class Door:
    """Who may come in.

    Args:
        later: what does small writes that nobody waits for.
    """

    settings: Settings
    store: Store
    recent_callers: RecentCallers
    now: Callable[[], datetime]
    later: ThreadPoolExecutor

    def let_in(self, connection: HTTPConnection) -> None:
        """Finds out who calls, and whether they may; a refusal of authority is written down.

        Raises:
            NotSignedIn, NotAllowed: they may not.
        """
        name, now = endpoint(connection), self.now()
        caller = NOBODY
        try:
            if AUTHORITY.get(name, SIGNED_IN) is not ANYBODY:
                caller = self._identify(connection, now)
            check_origin(connection, self.settings, caller)
            check_authority(name, caller)
        except NotAllowed as refusal:
            with self.store.write() as db:
                said = {"endpoint": name, "why": str(refusal), "code": refusal.message.code}
                audit.record(db, caller.who, "authority.refuse", said, now=now)
            raise
        if caller.stale:
            self.later.submit(self._touch, caller, now)
        connection.state.caller = caller

    def _identify(self, connection: HTTPConnection, now: datetime) -> Caller:
        """By the database; while that is away, as it said last."""
        try:
            with self.store.read() as db:
                caller = identify_caller(db, connection, self.settings, now)
        except SQLAlchemyError:
            recent = self.recent_callers.recall(connection, now)
            if recent is None:
                raise
            return replace(recent, stale=False)
        self.recent_callers.remember(connection, caller, now)
        return caller

    def _touch(self, caller: Caller, now: datetime) -> None:
        """Writes down that the session or the key was used; nobody waits for it."""
        key, session = update(ApiKey).where(ApiKey.name == caller.name), update(SignIn).where(SignIn.token_hash == caller.session)
        used = key if caller.session is None else session
        try:
            with self.store.write() as db:
                db.execute(used.values(used_at=now))
        except SQLAlchemyError:
            log.warning("the last use of a session or a key could not be written down")


DoorDep = Annotated[Door, depend_on("door")]


def let_in(connection: HTTPConnection, door: DoorDep) -> None:
    """Dependency of the whole application: every request and every websocket goes through it first.

    Raises:
        NotSignedIn, NotAllowed: the caller may not.
    """
    door.let_in(connection)
