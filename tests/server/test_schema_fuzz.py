"""Requests made up from the OpenAPI description: never a 500, never an answer that the description does not know."""

from __future__ import annotations

import pytest
import schemathesis
from fastapi import FastAPI
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis import Case
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import content_type_conformance, response_schema_conformance, status_code_conformance
from starlette.types import ASGIApp, Receive, Scope, Send

from server.auth import COOKIE, CSRF_HEADER
from server.roles import Role
from tests.server.people import As

CHECKS = [not_a_server_error, content_type_conformance, response_schema_conformance, status_code_conformance]
FUZZED = [
    "POST /api/session", "GET /api/session", "PUT /api/session/password", "GET /api/accounts", "POST /api/accounts",
    "PATCH /api/accounts/{account}", "GET /api/keys", "POST /api/keys", "DELETE /api/keys/{key}", "GET /api/audit", "GET /api/cells",
    "GET /api/cells/{cell}", "PUT /api/cells/{cell}/zones/{zone}", "GET /problems/{kind}", "GET /health",
]  # fmt: skip
MADE_UP = settings(
    max_examples=6,
    database=None,
    deadline=None,
    derandomize=True,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)


def running_already(app: FastAPI) -> ASGIApp:
    """The app without its start and end: the fixture has started it, and each made-up request would start it again."""

    async def requests_only(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "lifespan":
            await app(scope, receive, send)
            return
        for step in ("startup", "shutdown"):
            await receive()
            await send({"type": f"lifespan.{step}.complete"})

    return requests_only


@pytest.mark.parametrize("endpoint", FUZZED)
def test_made_up_requests_are_answered_as_described(endpoint: str, app: FastAPI, signed_in: As) -> None:
    client = signed_in(Role.operator, Role.engineer, Role.admin)
    method, path = endpoint.split(" ")
    operation = schemathesis.openapi.from_asgi("/openapi.json", running_already(app))[path][method]

    @MADE_UP
    @given(case=operation.as_strategy())
    def answered(case: Case) -> None:
        headers = {CSRF_HEADER: client.headers[CSRF_HEADER]}
        case.call_and_validate(checks=CHECKS, headers=headers, cookies={COOKIE: client.cookies[COOKIE]})

    answered()
