"""Every error as `application/problem+json` (RFC 9457): what, where, the value against the limit, and the next step."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from http import HTTPStatus
from math import ceil
from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from core import errors as core_errors
from core.errors import BadInput, HeftError, Stopped, slug
from server.http import errors
from server.telemetry.request_context import request_id

MEDIA_TYPE = "application/problem+json"
STORE_RETRY_S = 1.0


class Flaw(BaseModel):
    """One thing that cannot be used: in the request, or in a cell."""

    where: str
    found: str
    expected: str


class Problem(BaseModel):
    """What went wrong; `type` names the kind, `detail` is a sentence for a person."""

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={
            "examples": [
                {
                    "type": "/problems/bad-cell",
                    "title": "The cell cannot be used",
                    "status": 422,
                    "detail": "cell.toml: limits.clearance_m: found -0.1, expected greater than 0",
                    "request_id": "4f1c2a9be7d34a06",
                    "flaws": [{"where": "cell.toml: limits.clearance_m", "found": "-0.1", "expected": "greater than 0"}],
                }
            ]
        },
    )

    type: str
    title: str
    status: int
    detail: str
    request_id: str
    flaws: list[Flaw] = Field(default_factory=list)
    value: float | None = None
    """What was measured, SI, where a limit was exceeded."""
    limit: float | None = None
    retry_after_s: float | None = None
    allowed: list[str] | None = None
    """What would be accepted instead: methods, commands."""


@dataclass(frozen=True)
class Kind:
    """A kind of problem: its HTTP status, its title, and what it means where no error's docstring says so."""

    status: HTTPStatus
    title: str
    meaning: str = ""


KINDS: dict[type[HeftError], Kind] = {
    HeftError: Kind(HTTPStatus.INTERNAL_SERVER_ERROR, "The engine failed"),
    core_errors.BadInput: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "The input cannot be used"),
    core_errors.BadCell: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "The cell cannot be used"),
    core_errors.BadRobot: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "The robot model cannot be used"),
    core_errors.BadPayload: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "No rigid body can have this payload"),
    core_errors.BadTwin: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "The cell's twin cannot be used"),
    core_errors.BadRecording: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "The recording cannot be used"),
    core_errors.Refused: Kind(HTTPStatus.CONFLICT, "The cell leaves no safe way to do it"),
    core_errors.NoStartConfiguration: Kind(HTTPStatus.CONFLICT, "No start configuration"),
    core_errors.NoPath: Kind(HTTPStatus.CONFLICT, "No collision-free path"),
    core_errors.TooHeavy: Kind(HTTPStatus.CONFLICT, "The load is too heavy for the robot"),
    core_errors.PlanDisputed: Kind(HTTPStatus.CONFLICT, "The finished plan was not confirmed"),
    core_errors.Stopped: Kind(HTTPStatus.CONFLICT, "The guard stopped the robot"),
    core_errors.TooClose: Kind(HTTPStatus.CONFLICT, "Too close to an obstacle or a protected zone"),
    core_errors.TooFast: Kind(HTTPStatus.CONFLICT, "Too fast"),
    core_errors.OutOfLimits: Kind(HTTPStatus.CONFLICT, "A joint left its limits"),
    core_errors.OverLoad: Kind(HTTPStatus.CONFLICT, "The wrist wrench exceeds its limit"),
    core_errors.BadState: Kind(HTTPStatus.CONFLICT, "The robot's state cannot be trusted"),
    core_errors.SensorFrozen: Kind(HTTPStatus.CONFLICT, "The wrench does not change any more"),
    core_errors.RobotStateLate: Kind(HTTPStatus.CONFLICT, "The robot's state came too late"),
    core_errors.Held: Kind(HTTPStatus.CONFLICT, "The run is on hold"),
    core_errors.Commanded: Kind(HTTPStatus.CONFLICT, "The run was stopped on request"),
    core_errors.HoldExpired: Kind(HTTPStatus.CONFLICT, "Nobody came back to a run on hold"),
    core_errors.ControlLost: Kind(HTTPStatus.CONFLICT, "Nobody is in control of the robot"),
    core_errors.Interrupted: Kind(HTTPStatus.CONFLICT, "The run was interrupted"),
    errors.ServiceError: Kind(HTTPStatus.INTERNAL_SERVER_ERROR, "The service failed"),
    errors.NotSignedIn: Kind(HTTPStatus.UNAUTHORIZED, "Not signed in"),
    errors.NotAllowed: Kind(HTTPStatus.FORBIDDEN, "Not allowed"),
    errors.NotFound: Kind(HTTPStatus.NOT_FOUND, "Not found"),
    errors.Conflict: Kind(HTTPStatus.CONFLICT, "It does not go with the present state"),
    errors.Unprocessable: Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "It cannot be done"),
    errors.TooLarge: Kind(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, "The body is too large"),
    errors.TooMany: Kind(HTTPStatus.TOO_MANY_REQUESTS, "Asked too often"),
    errors.StoreUnavailable: Kind(HTTPStatus.SERVICE_UNAVAILABLE, "The store does not answer"),
    errors.NoRoom: Kind(HTTPStatus.INSUFFICIENT_STORAGE, "There is no room on the disk"),
}

HTTP_KINDS: dict[str, Kind] = {
    "bad-request": Kind(HTTPStatus.UNPROCESSABLE_ENTITY, "The request cannot be used", "The body, path or query does not fit the schema."),
    "method-not-allowed": Kind(HTTPStatus.METHOD_NOT_ALLOWED, "Method not allowed", "The address is right, the method is not."),
    "internal-error": Kind(HTTPStatus.INTERNAL_SERVER_ERROR, "The service failed", "An error that nobody foresaw; the log has it."),
    "http-error": Kind(HTTPStatus.BAD_REQUEST, "The request cannot be used", "Refused before it reached a route."),
}
"""What the web framework refuses by itself."""


def kinds_by_name() -> dict[str, Kind]:
    """Every kind under the last part of its `type`."""
    ours = {slug(error.__name__): replace(kind, meaning=(error.__doc__ or "").partition("\n")[0]) for error, kind in KINDS.items()}
    return ours | HTTP_KINDS


def kind_of(error: HeftError) -> tuple[type[HeftError], Kind]:
    """The nearest class of the error's tree that has a kind."""
    return next((each, KINDS[each]) for each in type(error).__mro__ if each in KINDS)


def problem_of(error: HeftError) -> Problem:
    """An error of the engine or the service as a problem."""
    known, kind = kind_of(error)
    more: dict[str, Any] = {}
    if isinstance(error, BadInput):
        more["flaws"] = flaws_of([error, *error.others])
    if isinstance(error, Stopped):
        more |= {"value": error.value, "limit": error.limit}
    if isinstance(error, errors.StoreUnavailable):
        more["retry_after_s"] = STORE_RETRY_S
    if isinstance(error, errors.TooMany):
        more["retry_after_s"] = error.retry_after_s
    if isinstance(error, errors.Conflict) and error.allowed:
        more["allowed"] = list(error.allowed)
    return problem(slug(known.__name__), kind, str(error), **more)


def flaws_of(errors: Iterable[BadInput]) -> list[Flaw]:
    """What is wrong, as an answer tells it."""
    return [Flaw(where=each.where, found=each.found, expected=each.expected) for each in errors]


def problem(type_name: str, kind: Kind, detail: str, **more: Any) -> Problem:
    """A problem of the request at hand."""
    return Problem(type=f"/problems/{type_name}", title=kind.title, status=kind.status, detail=detail, request_id=request_id.get(), **more)


def headers_of(found: Problem) -> dict[str, str]:
    """The headers that say the same to a client that reads no body."""
    headers = {"Cache-Control": "no-store"}
    if found.retry_after_s is not None:
        headers["Retry-After"] = str(ceil(found.retry_after_s))
    if found.status == HTTPStatus.UNAUTHORIZED:
        headers["WWW-Authenticate"] = 'Bearer realm="heft"'
    return headers
