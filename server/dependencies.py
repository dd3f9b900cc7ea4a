"""What routes ask for, as types; and the door that every request and websocket goes through first."""

from __future__ import annotations

import logging
from dataclasses import replace
from datetime import datetime
from typing import Annotated

from fastapi import Depends
from sqlalchemy import update
from sqlalchemy.exc import SQLAlchemyError
from starlette.requests import HTTPConnection

from server import audit
from server.accounts import SignIn
from server.auth import NOBODY, Caller, check_authority, check_origin, identify
from server.authority import ANYBODY, AUTHORITY, SIGNED_IN
from server.cell_folder import CellFolder
from server.errors import NotAllowed
from server.service import Service
from server.store import Store

log = logging.getLogger("heft.auth")


def service(connection: HTTPConnection) -> Service:
    """The running service."""
    found: Service = connection.app.state.service
    return found


def endpoint(connection: HTTPConnection) -> str:
    """As the table of authority names it, "PUT /api/cells/{cell}" or "WS /api/runs/{run}/live"."""
    method = "WS" if connection.scope["type"] == "websocket" else connection.scope["method"]
    return f"{method} {connection.scope['route'].path}"


def let_in(connection: HTTPConnection, here: Annotated[Service, Depends(service)]) -> None:
    """Every request and every websocket goes through here first; a refusal of authority is written down."""
    name, now = endpoint(connection), here.now()
    caller = NOBODY
    try:
        if AUTHORITY.get(name, SIGNED_IN) is not ANYBODY:
            caller = _identified(connection, here, now)
        check_origin(connection, here.settings, caller)
        check_authority(name, caller)
    except NotAllowed as refusal:
        with here.store.write() as db:
            audit.record(db, caller.who, "authority.refuse", {"endpoint": name, "why": str(refusal)}, now=now)
        raise
    if caller.stale:
        here.later.submit(_touch, here, caller, now)
    connection.state.caller = caller


def _identified(connection: HTTPConnection, here: Service, now: datetime) -> Caller:
    """By the database; while that is away, as it said last."""
    try:
        with here.store.read() as db:
            caller = identify(db, connection, here.settings, now)
    except SQLAlchemyError:
        recent = here.recent_callers.recall(connection, now)
        if recent is None:
            raise
        return replace(recent, stale=False)
    here.recent_callers.remember(connection, caller, now)
    return caller


def _touch(here: Service, caller: Caller, now: datetime) -> None:
    """Writes down that the session was used; nobody waits for it."""
    try:
        with here.store.write() as db:
            db.execute(update(SignIn).where(SignIn.token_hash == caller.session).values(used_at=now))
    except SQLAlchemyError:
        log.warning("the last use of a session could not be written down")


def _caller(connection: HTTPConnection) -> Caller:
    found: Caller = connection.state.caller
    return found


def _store(here: Annotated[Service, Depends(service)]) -> Store:
    return here.store


def _cells(here: Annotated[Service, Depends(service)]) -> CellFolder:
    return here.cells


def _now(here: Annotated[Service, Depends(service)]) -> datetime:
    return here.now()


def address(connection: HTTPConnection) -> str:
    """Where the request comes from."""
    return "unknown" if connection.client is None else connection.client.host


Here = Annotated[Service, Depends(service)]
Stored = Annotated[Store, Depends(_store)]
Cells = Annotated[CellFolder, Depends(_cells)]
Asking = Annotated[Caller, Depends(_caller)]
Now = Annotated[datetime, Depends(_now)]
Address = Annotated[str, Depends(address)]
