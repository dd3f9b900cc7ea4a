"""Answers a failed request or websocket handshake with its problem; nothing leaves the service in another form."""

from __future__ import annotations

import logging
from dataclasses import replace
from http import HTTPStatus

from fastapi import FastAPI
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from sqlalchemy.exc import InterfaceError, OperationalError
from starlette.exceptions import HTTPException
from starlette.requests import HTTPConnection

from core.errors import HeftError
from core.words.message import Message
from server.http.errors import StoreUnavailable
from server.http.flaws import flaw_of, list_request_messages
from server.http.middleware import BodyTooLargeError
from server.http.problems import HTTP_KINDS, MEDIA_TYPE, ProblemDetails, headers_of, kinds_by_name, problem, problem_of

log = logging.getLogger("heft.problems")


class ProblemAnswer(JSONResponse):
    """A problem of RFC 9457, which answers a request or a handshake."""

    media_type = MEDIA_TYPE

    def __init__(self, found: ProblemDetails, headers: dict[str, str] | None = None) -> None:
        self.found = found
        super().__init__(found.model_dump(mode="json", exclude_none=True), found.status, headers_of(found) | (headers or {}))


def answer_with_problems(app: FastAPI) -> None:
    """Registers what answers each kind of error."""
    app.add_exception_handler(HeftError, _answer_heft_error)
    app.add_exception_handler(RequestValidationError, _answer_validation_error)
    app.add_exception_handler(HTTPException, _answer_http_error)
    app.add_exception_handler(OperationalError, _answer_store_error)
    app.add_exception_handler(InterfaceError, _answer_store_error)
    app.add_exception_handler(Exception, _answer_unexpected_error)


async def _answer_heft_error(_: HTTPConnection, error: Exception) -> ProblemAnswer:
    assert isinstance(error, HeftError)
    return ProblemAnswer(problem_of(error))


async def _answer_validation_error(_: HTTPConnection, error: Exception) -> ProblemAnswer:
    assert isinstance(error, RequestValidationError)
    kind, found = HTTP_KINDS["bad-request"], list_request_messages(error.errors())
    flaw, more, flaws = found[0], len(found) - 1, [flaw_of(each) for each in found]
    if any(each["type"] == "json_invalid" for each in error.errors()):
        kind = replace(kind, status=HTTPStatus.BAD_REQUEST)
        return ProblemAnswer(problem(Message.of("request-no-json", flaw=flaw), "bad-request", kind, flaws=flaws))
    return ProblemAnswer(problem(Message.of("request-unfit", flaw=flaw, more=more), "bad-request", kind, flaws=flaws))


async def _answer_http_error(connection: HTTPConnection, error: Exception) -> ProblemAnswer:
    assert isinstance(error, HTTPException)
    status = HTTPStatus(error.status_code)
    name, message = _explain_http_error(error, connection.scope.get("method", "websocket"), connection.scope["path"][:120])
    allow = (error.headers or {}).get("Allow")
    allowed = sorted(allow.split(", ")) if allow else None
    found = problem(message, name, replace(kinds_by_name()[name], status=status), allowed=allowed)
    return ProblemAnswer(found, dict(error.headers or {}))


def _explain_http_error(error: HTTPException, method: str, path: str) -> tuple[str, Message]:
    """What the web framework refused: its kind and its message."""
    if isinstance(error, BodyTooLargeError):
        return "too-large", Message.of("request-body-too-large", method=method, path=path, limit_bytes=error.limit_bytes)
    if error.status_code == HTTPStatus.NOT_FOUND:
        return "not-found", Message.of("request-address-unknown", method=method, path=path)
    if error.status_code == HTTPStatus.METHOD_NOT_ALLOWED:
        return "method-not-allowed", Message.of("request-method-not-allowed", method=method, path=path)
    return "http-error", Message.of("request-refused", method=method, path=path, reason=str(error.detail)[:200])


async def _answer_store_error(_: HTTPConnection, error: Exception) -> ProblemAnswer:
    log.error("store", exc_info=error)
    return ProblemAnswer(problem_of(StoreUnavailable("store-unavailable")))


async def _answer_unexpected_error(_: HTTPConnection, error: Exception) -> ProblemAnswer:
    log.error("unexpected", exc_info=error)
    return ProblemAnswer(problem(Message.of("request-unforeseen"), "internal-error", HTTP_KINDS["internal-error"]))
