"""Every error as `application/problem+json` (RFC 9457): what, where, the value against the limit, and the next step."""

from __future__ import annotations

from dataclasses import dataclass, replace
from http import HTTPStatus
from math import ceil
from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from core import errors as core_errors
from core.errors import BadInput, HeftError, Stopped, slug
from core.words.message import Message
from server.http import errors
from server.http.flaws import Flaw, list_flaws
from server.telemetry.request_context import request_id

MEDIA_TYPE = "application/problem+json"
STORE_RETRY_S = 1.0


class ProblemDetails(BaseModel):
    """What went wrong."""

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={
            "examples": [
                {
                    "type": "/problems/zone-not-moved",
                    "title": "It does not go with the present state",
                    "status": 409,
                    "detail": 'zone "operator": is as the cell\'s file has it; there is nothing to undo',
                    "kind": "conflict",
                    "parameters": {"zone": "operator"},
                    "request_id": "4f1c2a9be7d34a06",
                }
            ]
        },
    )

    type: str = Field(description="Address of what describes the situation, `/problems/{code}`.", examples=["/problems/zone-not-moved"])
    title: str = Field(description="What kind of thing it is, in English.", examples=["It does not go with the present state"])
    status: int = Field(description="HTTP status.", examples=[409])
    detail: str = Field(
        description="What happened, the value against the limit, and the next step, in English.",
        examples=['zone "operator": is as the cell\'s file has it; there is nothing to undo'],
    )
    kind: str = Field(description="For programs that know no single situations: few, and stable.", examples=["conflict"])
    parameters: dict[str, Any] = Field(
        default_factory=dict,
        description="What the words of the situation name: numbers in SI with the unit in their name.",
        examples=[{"zone": "operator"}],
    )
    request_id: str = Field(
        description="Names the request in the service's log; also the header `X-Request-Id`.", examples=["4f1c2a9be7d34a06"]
    )
    flaws: list[Flaw] = Field(default_factory=list, description="All that cannot be used, where it is the request or a cell.")
    value: float | None = Field(default=None, description="What was measured, in SI, where a limit was exceeded.", examples=[0.28])
    limit: float | None = Field(default=None, description="That limit, in the same unit.", examples=[0.25])
    retry_after_s: float | None = Field(default=None, description="When to ask again, s; also the header `Retry-After`.", examples=[1.0])
    allowed: list[str] | None = Field(
        default=None, description="What would be accepted instead: methods, commands.", examples=[["stop", "abort"]]
    )


@dataclass(frozen=True)
class ProblemType:
    """A kind of problem: its HTTP status, its title, and what it means where no error's docstring says so."""

    status: HTTPStatus
    title: str
    meaning: str = ""


KINDS: dict[type[HeftError], ProblemType] = {
    HeftError: ProblemType(HTTPStatus.INTERNAL_SERVER_ERROR, "The engine failed"),
    core_errors.BadInput: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "The input cannot be used"),
    core_errors.BadCell: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "The cell cannot be used"),
    core_errors.BadRobot: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "The robot model cannot be used"),
    core_errors.BadPayload: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "No rigid body can have this payload"),
    core_errors.BadTwin: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "The cell's twin cannot be used"),
    core_errors.BadZone: ProblemType(HTTPStatus.CONFLICT, "The zone cannot be drawn like that"),
    core_errors.BadRecording: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "The recording cannot be used"),
    core_errors.MissingPackage: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "A driver's package is not installed"),
    core_errors.Refused: ProblemType(HTTPStatus.CONFLICT, "The cell leaves no safe way to do it"),
    core_errors.NoStartConfiguration: ProblemType(HTTPStatus.CONFLICT, "No start configuration"),
    core_errors.NoPath: ProblemType(HTTPStatus.CONFLICT, "No collision-free path"),
    core_errors.NoRoomAtHome: ProblemType(HTTPStatus.CONFLICT, "No room for the payload box at home"),
    core_errors.NotConnected: ProblemType(HTTPStatus.CONFLICT, "The robot or its sensor cannot be reached"),
    core_errors.WrongRobot: ProblemType(HTTPStatus.CONFLICT, "Another robot is connected"),
    core_errors.PayloadNotTaken: ProblemType(HTTPStatus.CONFLICT, "The controller did not take the payload"),
    core_errors.UnusableSensor: ProblemType(HTTPStatus.CONFLICT, "The sensor cannot be used as it is"),
    core_errors.TooHeavy: ProblemType(HTTPStatus.CONFLICT, "The load is too heavy for the robot"),
    core_errors.PlanDisputed: ProblemType(HTTPStatus.CONFLICT, "The finished plan was not confirmed"),
    core_errors.Stopped: ProblemType(HTTPStatus.CONFLICT, "The guard stopped the robot"),
    core_errors.TooClose: ProblemType(HTTPStatus.CONFLICT, "Too close to an obstacle or a protected zone"),
    core_errors.TooFast: ProblemType(HTTPStatus.CONFLICT, "Too fast"),
    core_errors.OutOfLimits: ProblemType(HTTPStatus.CONFLICT, "A joint left its limits"),
    core_errors.OverLoad: ProblemType(HTTPStatus.CONFLICT, "The wrist wrench exceeds its limit"),
    core_errors.BadState: ProblemType(HTTPStatus.CONFLICT, "The robot's state cannot be trusted"),
    core_errors.SensorFrozen: ProblemType(HTTPStatus.CONFLICT, "The wrench does not change any more"),
    core_errors.RobotStateLate: ProblemType(HTTPStatus.CONFLICT, "The robot's state came too late"),
    core_errors.ControllerStopped: ProblemType(HTTPStatus.CONFLICT, "The robot's controller stopped it"),
    core_errors.WrongKinematics: ProblemType(HTTPStatus.CONFLICT, "The robot moves otherwise than the cell says"),
    core_errors.WrongSensor: ProblemType(HTTPStatus.CONFLICT, "The wrench does not turn with the robot"),
    core_errors.SensorLate: ProblemType(HTTPStatus.CONFLICT, "The sensor sends nothing"),
    core_errors.SensorFault: ProblemType(HTTPStatus.CONFLICT, "The sensor's reading is no measurement"),
    core_errors.Held: ProblemType(HTTPStatus.CONFLICT, "The run is on hold"),
    core_errors.Commanded: ProblemType(HTTPStatus.CONFLICT, "The run was stopped on request"),
    core_errors.HoldExpired: ProblemType(HTTPStatus.CONFLICT, "Nobody came back to a run on hold"),
    core_errors.ControlLost: ProblemType(HTTPStatus.CONFLICT, "Nobody is in control of the robot"),
    core_errors.Interrupted: ProblemType(HTTPStatus.CONFLICT, "The run was interrupted"),
    errors.ServiceError: ProblemType(HTTPStatus.INTERNAL_SERVER_ERROR, "The service failed"),
    errors.NotSignedIn: ProblemType(HTTPStatus.UNAUTHORIZED, "Not signed in"),
    errors.NotAllowed: ProblemType(HTTPStatus.FORBIDDEN, "Not allowed"),
    errors.NotFound: ProblemType(HTTPStatus.NOT_FOUND, "Not found"),
    errors.Conflict: ProblemType(HTTPStatus.CONFLICT, "It does not go with the present state"),
    errors.Unprocessable: ProblemType(HTTPStatus.UNPROCESSABLE_ENTITY, "It cannot be done"),
    errors.TooLarge: ProblemType(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, "The body is too large"),
    errors.TooMany: ProblemType(HTTPStatus.TOO_MANY_REQUESTS, "Asked too often"),
    errors.StoreUnavailable: ProblemType(HTTPStatus.SERVICE_UNAVAILABLE, "The store does not answer"),
    errors.NoRoom: ProblemType(HTTPStatus.INSUFFICIENT_STORAGE, "There is no room on the disk"),
}

HTTP_KINDS: dict[str, ProblemType] = {
    "bad-request": ProblemType(
        HTTPStatus.UNPROCESSABLE_ENTITY, "The request cannot be used", "The body, path or query does not fit the schema."
    ),
    "method-not-allowed": ProblemType(HTTPStatus.METHOD_NOT_ALLOWED, "Method not allowed", "The address is right, the method is not."),
    "internal-error": ProblemType(HTTPStatus.INTERNAL_SERVER_ERROR, "The service failed", "An error that nobody foresaw; the log has it."),
    "http-error": ProblemType(HTTPStatus.BAD_REQUEST, "The request cannot be used", "Refused before it reached a route."),
}
"""What the web framework refuses by itself."""


def kinds_by_name() -> dict[str, ProblemType]:
    """Every kind under its name."""
    ours = {slug(error.__name__): replace(kind, meaning=(error.__doc__ or "").partition("\n")[0]) for error, kind in KINDS.items()}
    return ours | HTTP_KINDS


def find_problem_type(error: HeftError) -> tuple[type[HeftError], ProblemType]:
    """The nearest class of the error's tree that has a kind."""
    return next((each, KINDS[each]) for each in type(error).__mro__ if each in KINDS)


def problem_of(error: HeftError) -> ProblemDetails:
    """An error of the engine or the service as a problem."""
    known, kind = find_problem_type(error)
    more: dict[str, Any] = {}
    if isinstance(error, BadInput):
        more["flaws"] = list_flaws([error, *error.others])
    if isinstance(error, Stopped):
        more |= {"value": error.value, "limit": error.limit}
    if isinstance(error, errors.StoreUnavailable):
        more["retry_after_s"] = STORE_RETRY_S
    if isinstance(error, errors.TooMany):
        more["retry_after_s"] = error.retry_after_s
    if isinstance(error, errors.Conflict) and error.allowed:
        more["allowed"] = list(error.allowed)
    return problem(error.message, slug(known.__name__), kind, **more)


def problem(message: Message, name: str, kind: ProblemType, **more: Any) -> ProblemDetails:
    """A problem of the request at hand.

    Args:
        message: which situation it is.
        name: of its kind.
    """
    return ProblemDetails(
        type=f"/problems/{message.code}",
        title=kind.title,
        status=kind.status,
        detail=str(message),
        kind=name,
        parameters=message.model_dump(mode="json", include={"parameters"})["parameters"],
        request_id=request_id.get(),
        **more,
    )


def headers_of(found: ProblemDetails) -> dict[str, str]:
    """The headers that say the same to a client that reads no body."""
    headers = {"Cache-Control": "no-store"}
    if found.retry_after_s is not None:
        headers["Retry-After"] = str(ceil(found.retry_after_s))
    if found.status == HTTPStatus.UNAUTHORIZED:
        headers["WWW-Authenticate"] = 'Bearer realm="heft"'
    return headers
