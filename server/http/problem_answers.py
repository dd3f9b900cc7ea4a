"""Answers a failed request or websocket handshake with its problem; nothing leaves the service in another form."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import replace
from http import HTTPStatus
from typing import Any

from fastapi import FastAPI, WebSocket
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from sqlalchemy.exc import InterfaceError, OperationalError
from starlette.exceptions import HTTPException
from starlette.requests import HTTPConnection

from core.errors import HeftError
from core.files.schema_flaw import schema_flaw
from core.words.message import Message
from server.http.errors import StoreUnavailable
from server.http.problems import HTTP_KINDS, MEDIA_TYPE, Flaw, ProblemDetails, headers_of, kinds_by_name, problem, problem_of

log = logging.getLogger("heft.problems")

NEXT_STEPS = {
    HTTPStatus.NOT_FOUND: ("not-found", "there is nothing at this address; GET /openapi.json lists what there is"),
    HTTPStatus.METHOD_NOT_ALLOWED: ("method-not-allowed", "this address does not know the method; see `allowed`"),
    HTTPStatus.REQUEST_ENTITY_TOO_LARGE: ("too-large", "the body is too large; send a smaller one"),
}


def answer_with_problems(app: FastAPI) -> None:
    """Registers what answers each kind of error."""
    app.add_exception_handler(HeftError, _answer_heft_error)
    app.add_exception_handler(RequestValidationError, _answer_validation_error)
    app.add_exception_handler(HTTPException, _answer_http_error)
    app.add_exception_handler(OperationalError, _answer_store_error)
    app.add_exception_handler(InterfaceError, _answer_store_error)
    app.add_exception_handler(Exception, _answer_unexpected_error)


async def _answer_heft_error(connection: HTTPConnection, error: Exception) -> JSONResponse:
    assert isinstance(error, HeftError)
    return await _send(connection, problem_of(error))


async def _answer_validation_error(connection: HTTPConnection, error: Exception) -> JSONResponse:
    assert isinstance(error, RequestValidationError)
    flaws = list_request_flaws(error.errors())
    kind = HTTP_KINDS["bad-request"]
    if any(each["type"] == "json_invalid" for each in error.errors()):
        kind = replace(kind, status=HTTPStatus.BAD_REQUEST)
    detail = "; ".join(f"{flaw.where}: found {flaw.found}, expected {flaw.expected}" for flaw in flaws[:3])
    return await _send(connection, problem("bad-request", kind, detail, flaws=flaws))


async def _answer_http_error(connection: HTTPConnection, error: Exception) -> JSONResponse:
    assert isinstance(error, HTTPException)
    status = HTTPStatus(error.status_code)
    name, next_step = NEXT_STEPS.get(status, ("http-error", str(error.detail)))
    kind = replace(kinds_by_name()[name], status=status)
    allow = (error.headers or {}).get("Allow")
    method, path = connection.scope.get("method", "websocket"), connection.scope["path"]
    allowed = sorted(allow.split(", ")) if allow else None
    found = problem(name, kind, f"{method} {path[:120]}: {next_step}", allowed=allowed)
    return await _send(connection, found, dict(error.headers or {}))


async def _answer_store_error(connection: HTTPConnection, error: Exception) -> JSONResponse:
    log.error("store", exc_info=error)
    detail = "the database is locked, full or away; nothing was changed. Try again; if it stays so, see the service's log"
    return await _send(connection, problem_of(StoreUnavailable(detail)))


async def _answer_unexpected_error(connection: HTTPConnection, error: Exception) -> JSONResponse:
    log.error("unexpected", exc_info=error)
    detail = "an error that was not foreseen; the service's log has it under request_id"
    return await _send(connection, problem("internal-error", HTTP_KINDS["internal-error"], detail))


async def _send(connection: HTTPConnection, found: ProblemDetails, headers: dict[str, str] | None = None) -> JSONResponse:
    body = found.model_dump(mode="json", exclude_none=True)
    answer = JSONResponse(body, found.status, headers_of(found) | (headers or {}), MEDIA_TYPE)
    if isinstance(connection, WebSocket):
        await connection.send_denial_response(answer)
    return answer


def list_request_flaws(found: Sequence[Any]) -> list[Flaw]:
    """Pydantic's errors as ours; secrets are not repeated."""
    flaws = [schema_flaw(each) for each in found]
    told = [(flaw.key, Message.of(flaw.code, **(flaw.hide() if "password" in flaw.key else flaw).parameters)) for flaw in flaws]
    return [Flaw(where=key, found=message.say_part("found"), expected=message.say_part("expected")) for key, message in told]
