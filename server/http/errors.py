"""What the service itself refuses; the tree goes on from `core.errors`. `server.http.problems` says which HTTP status each is.

ServiceError(HeftError)
├── NotSignedIn        nobody is signed in, or the key is unknown, expired or revoked
├── NotAllowed         who asks may not do this
├── NotFound           there is no such thing
├── Conflict           it does not go with the state that things are in
├── Unprocessable      well formed, but it cannot be done
├── TooLarge           the body exceeds its limit
├── TooMany            asked too often; says when to ask again
├── StoreUnavailable   the database cannot be written now
└── NoRoom             the disk is full, or too full to begin
"""

from __future__ import annotations

from collections.abc import Sequence

from core.errors import HeftError
from core.words.message import Parameter


class ServiceError(HeftError):
    """Root of what the service refuses."""


class NotSignedIn(ServiceError):
    """Nobody is signed in, or the key is unknown, expired or revoked."""


class NotAllowed(ServiceError):
    """Who asks may not do this."""


class NotFound(ServiceError):
    """There is no such thing."""


class Conflict(ServiceError):
    """It does not go with the state that things are in.

    Args:
        code: the message that says what, and which states or commands would do.
        allowed: the commands that would be accepted now.
        parameters: what the message names.
    """

    def __init__(self, code: str, /, allowed: Sequence[str] = (), **parameters: Parameter) -> None:
        super().__init__(code, **parameters)
        self.allowed = tuple(allowed)


class Unprocessable(ServiceError):
    """Well formed, but it cannot be done."""


class TooLarge(ServiceError):
    """The body exceeds its limit."""


class TooMany(ServiceError):
    """Asked too often.

    Args:
        code: the message, which may name `retry_after_s`.
        retry_after_s: when to ask again.
        parameters: what else the message names.
    """

    def __init__(self, code: str, /, retry_after_s: float, **parameters: Parameter) -> None:
        super().__init__(code, retry_after_s=retry_after_s, **parameters)
        self.retry_after_s = retry_after_s


class StoreUnavailable(ServiceError):
    """The database is locked, full or away."""


class NoRoom(ServiceError):
    """The disk has too little room for what is to be written."""
