"""Who is asking, and whether they may: a browser by its cookie, a machine by its key; deny by default.

A browser's cookie travels with requests that other pages make, so a request that changes something also has to carry the session's
CSRF token, and come from one of our own pages as far as the browser says where from. A websocket of a browser must say so.
"""

from __future__ import annotations

import secrets
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Annotated
from urllib.parse import urlsplit

from fastapi import Depends
from sqlalchemy.orm import Session
from starlette.requests import HTTPConnection

from server.http.dependencies import depend_on
from server.http.errors import NotAllowed, NotSignedIn
from server.http.openapi import COOKIE, CSRF_HEADER
from server.people.accounts import KEY_PREFIX, Account, ApiKey, SignIn, sha256
from server.people.authority import AUTHORITY
from server.people.roles import Role, name_roles
from server.settings import Settings

SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})
RECENT = timedelta(minutes=10)  # for which the database may be away before nobody is let in any more
TOUCH = timedelta(minutes=1)  # how exactly the last use of a session or a key is known


@dataclass(frozen=True)
class Caller:
    """Who is asking.

    Args:
        who: as the audit log names them, "account:anna", "key:line-3" or "nobody".
        csrf_token: of a browser's session; None for a machine.
        stale: the last use of the session or the key ought to be written down.
    """

    who: str
    roles: frozenset[Role]
    csrf_token: str | None = None
    session: str | None = None
    stale: bool = False

    @property
    def name(self) -> str:
        """Of the account or key."""
        return self.who.partition(":")[2]


NOBODY = Caller("nobody", frozenset())


class RecentCallers:
    """Who was let in lately, for as long as the database is away: whoever is at the cell must be able to act then, too.

    What ends a sign-in while the database is there ends it here as well.
    """

    def __init__(self) -> None:
        self._known: dict[str, tuple[Caller, datetime]] = {}

    def remember(self, connection: HTTPConnection, caller: Caller, now: datetime) -> None:
        """The database has just said who it is."""
        shown = _hash_credentials(connection)
        if shown is not None:
            self._known[shown] = (caller, now)
            for old in [each for each, (_, at) in self._known.items() if now - at > RECENT]:
                del self._known[old]

    def recall(self, connection: HTTPConnection, now: datetime) -> Caller | None:
        """Who it was, where that is not long ago."""
        caller, at = self._known.get(_hash_credentials(connection) or "", (None, now))
        return caller if now - at <= RECENT else None

    def forget(self, who: str) -> None:
        """Somebody has signed out, or may do less."""
        self._known = {shown: known for shown, known in self._known.items() if known[0].who != who}


def _hash_credentials(connection: HTTPConnection) -> str | None:
    """Hash of the key or cookie that is shown."""
    secret = connection.headers.get("authorization") or connection.cookies.get(COOKIE)
    return None if secret is None else sha256(secret)


def identify_caller(db: Session, connection: HTTPConnection, settings: Settings, now: datetime) -> Caller:
    """The caller, by key or by cookie; NOBODY where neither is shown.

    Raises:
        NotSignedIn: what is shown is unknown, expired or revoked.
    """
    scheme, _, key = connection.headers.get("authorization", "").partition(" ")
    if scheme.lower() == "bearer":
        return _identify_by_key(db, key.strip(), now)
    token = connection.cookies.get(COOKIE)
    return NOBODY if token is None else _identify_by_cookie(db, token, settings, now)


def _identify_by_key(db: Session, key: str, now: datetime) -> Caller:
    row = db.get(ApiKey, key[:KEY_PREFIX])
    if row is None or not secrets.compare_digest(row.key_hash, sha256(key)) or (row.expires_at is not None and row.expires_at <= now):
        raise NotSignedIn("people-key-refused")
    return Caller(f"key:{row.name}", frozenset({Role(row.role)}), stale=row.used_at is None or now - row.used_at > TOUCH)


def _identify_by_cookie(db: Session, token: str, settings: Settings, now: datetime) -> Caller:
    row = db.get(SignIn, sha256(token))
    account = None if row is None else db.get(Account, row.account)
    if (
        row is None
        or account is None
        or account.disabled
        or row.created_at + settings.session_lasts <= now
        or row.used_at + settings.idle_lasts <= now
    ):
        raise NotSignedIn("people-session-over")
    return Caller(f"account:{account.name}", account.roles, row.csrf_token, row.token_hash, stale=now - row.used_at > TOUCH)


def check_origin(connection: HTTPConnection, settings: Settings, caller: Caller) -> None:
    """The request comes from a page of ours, where a browser could have sent it from another.

    Raises:
        NotAllowed: it does not, or it lacks the session's CSRF token.
    """
    websocket = connection.scope["type"] == "websocket"
    if not websocket and connection.scope["method"] in SAFE_METHODS:
        return
    origin, site = connection.headers.get("origin"), connection.headers.get("sec-fetch-site")
    ours = origin is not None and (urlsplit(origin).netloc == connection.headers.get("host") or origin in settings.origins)
    if (origin is not None and not ours) or (site not in (None, "same-origin", "none") and not ours):
        raise NotAllowed("people-origin-foreign", origin=(origin or site or "")[:80])
    if caller.csrf_token is None:
        return
    if websocket and origin is None:
        raise NotAllowed("people-origin-missing")
    if not websocket and not secrets.compare_digest(connection.headers.get(CSRF_HEADER, "").encode(), caller.csrf_token.encode()):
        raise NotAllowed("people-csrf-token-wrong", header=CSRF_HEADER)


def check_authority(endpoint: str, caller: Caller) -> None:
    """The table of authority lets the caller in.

    Raises:
        NotSignedIn: somebody has to be signed in.
        NotAllowed: none of the caller's roles may do it, or the endpoint stands in no table.
    """
    if endpoint not in AUTHORITY:
        raise NotAllowed("people-endpoint-closed", endpoint=endpoint)
    allowed = AUTHORITY[endpoint]
    if allowed is None:
        return
    if caller == NOBODY:
        raise NotSignedIn("people-not-signed-in", endpoint=endpoint)
    if not caller.roles & allowed:
        if not caller.roles:
            raise NotAllowed("people-without-role", endpoint=endpoint, who=caller.who, needed=name_roles(allowed))
        raise NotAllowed(
            "people-role-lacking", endpoint=endpoint, who=caller.who, roles=name_roles(caller.roles), needed=name_roles(allowed)
        )


def _get_caller(connection: HTTPConnection) -> Caller:
    found: Caller = connection.state.caller
    return found


RecentCallersDep = Annotated[RecentCallers, depend_on("recent_callers")]
CallerDep = Annotated[Caller, Depends(_get_caller)]
