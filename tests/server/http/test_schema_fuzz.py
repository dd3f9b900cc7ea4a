"""Requests made up from the OpenAPI description: never a 500, never an answer that the description does not know."""

from __future__ import annotations

import asyncio
from itertools import count
from typing import Any

import pytest
import schemathesis
from argon2 import PasswordHasher
from fastapi import FastAPI
from fastapi.testclient import TestClient
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis.stateful import run_state_machine_as_test
from schemathesis import Case, GenerationMode, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from server.http.openapi import COOKIE, CSRF_HEADER
from server.people.authority import AUTHORITY
from server.people.roles import Role
from tests.server.made_people import As

LEFT_OUT = {
    "POST /api/runs": "each makes a process that plans",
    "POST /api/diagnoses/uploads": "takes a zip; tests/server/jobs/test_diagnosis_routes.py",
    "POST /api/trials": "each runs for a quarter of a minute",
    "PUT /api/imports/{log_import}/files/{file}": "takes a file; tests/server/imports/test_routes.py",
    "POST /api/drafts": "takes a robot's description or a zip; tests/server/cells/test_draft_routes.py",
    "POST /api/cells": "takes a zip; tests/server/cells/test_uploads.py",
    "POST /api/cells/validate": "the same",
    "PUT /api/cells/{cell}": "the same",
    "GET /": "a page, in no description",
    "GET /assets/{path:path}": "the same",
    "GET /viewer/{cell}": "the same",
    "GET /viewer/{cell}/{path:path}": "the same",
    "GET /openapi.json": "the description itself",
    "GET /asyncapi.json": "the same of the websockets",
    "GET /docs": "both as a page",
    "DELETE /api/session": "would sign the others out",
    "GET /api/support/bundle": "takes nothing that could be made up, and seconds",
}
FUZZED = sorted(name for name in AUTHORITY if name not in LEFT_OUT and not name.startswith("WS "))
CHAINED = {
    r"^/api/runs(/\{run\}(/events|/result|/plan|/acceptance)?)?$": {
        "POST /api/runs",
        "GET /api/runs/{run}",
        "GET /api/runs/{run}/events",
        "DELETE /api/runs/{run}",
    },
    r"^/api/keys": {"POST /api/keys", "DELETE /api/keys/{key}"},
    r"^/api/accounts": {"POST /api/accounts", "PATCH /api/accounts/{account}"},
    r"^/api/webhooks": {"POST /api/webhooks", "GET /api/webhooks/{webhook}/deliveries", "DELETE /api/webhooks/{webhook}"},
}
"""What is made there has a name, under which it is read, used and taken away again; what must succeed on the way."""
LISTS = ["list_runs", "list_keys", "list_accounts", "list_webhooks"]
"""They grow from one example to the next, so examples would not be repeatable."""
SENDING = "test_webhook"
"""Goes to whatever address was made up."""
KNOWN = {"cell": "lwr4_bench", "payload": "steel_block"}
"""What no made-up body would hit upon."""
OF_THE_CELL = ("speed_m_s", "start_rad")
"""What has to go with the cell, which the description does not say."""
IN_A_ROW = settings(
    max_examples=20,
    stateful_step_count=8,
    database=None,
    deadline=None,
    derandomize=True,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)
MADE_UP = settings(
    max_examples=4,
    database=None,
    deadline=None,
    derandomize=True,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)


def running_already(app: ASGIApp) -> ASGIApp:
    """The app without its start and end: the fixture has started it, and each made-up request would start it again."""

    async def requests_only(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "lifespan":
            await app(scope, receive, send)
            return
        for step in ("startup", "shutdown"):
            await receive()
            await send({"type": f"lifespan.{step}.complete"})

    return requests_only


def in_its_own_loop(app: FastAPI, running: TestClient) -> ASGIApp:
    """The app where it runs, as in a service; each made-up request has a loop of its own otherwise."""

    async def passed_on(scope: Scope, receive: Receive, send: Send) -> None:
        heard, said = [await receive()], []

        async def hear() -> Message:
            return heard.pop() if heard else {"type": "http.disconnect"}

        async def say(message: Message) -> None:
            said.append(message)

        assert running.portal is not None
        await asyncio.to_thread(running.portal.call, app, scope, hear, say)
        for message in said:
            await send(message)

    return passed_on


def read_description(app: ASGIApp, client: TestClient) -> Any:
    """As whoever is signed in reads it."""
    return schemathesis.openapi.from_asgi("/openapi.json", app, headers={"Cookie": f"{COOKIE}={client.cookies[COOKIE]}"})


@pytest.mark.parametrize("endpoint", FUZZED)
def test_made_up_requests_are_answered_as_described(endpoint: str, app: FastAPI, signed_in: As) -> None:
    client = signed_in(Role.operator, Role.engineer, Role.admin)
    method, path = endpoint.split(" ")
    operation = read_description(running_already(app), client)[path][method]

    @MADE_UP
    @given(case=operation.as_strategy())
    def answered(case: Case) -> None:
        headers = {CSRF_HEADER: client.headers[CSRF_HEADER]}
        case.call_and_validate(headers=headers, cookies={COOKIE: client.cookies[COOKIE]})

    answered()


@pytest.mark.parametrize("paths", CHAINED)
def test_what_one_answer_names_is_asked_for_next_and_answered_as_described(
    paths: str, nothing_planned: None, app: FastAPI, nobody: TestClient, signed_in: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Requests one after the other: what is made is read and taken away again, in whatever order the description allows."""
    monkeypatch.setattr("server.people.accounts.hasher", PasswordHasher(time_cost=1, memory_cost=8, parallelism=1))  # dozens of accounts
    client = signed_in(Role.operator, Role.engineer, Role.admin)
    described = read_description(running_already(in_its_own_loop(app, nobody)), client)
    described.config.generation.update(modes=[GenerationMode.POSITIVE])
    described.raw_schema["components"]["schemas"]["RunCreate"]["properties"].pop("order_id")  # the plant's, taken for what we would make
    described = described.include(path_regex=paths).exclude(operation_id=[*LISTS, SENDING])
    answered: set[str] = set()
    number = count()

    class Chained(described.as_state_machine()):  # type: ignore[misc]  # a class that is made from the description
        def get_call_kwargs(self, case: Case) -> dict[str, Any]:
            del case
            return {"headers": {CSRF_HEADER: client.headers[CSRF_HEADER]}, "cookies": {COOKIE: client.cookies[COOKIE]}}

        def before_call(self, case: Case) -> None:
            if isinstance(case.body, dict):
                case.body |= {name: value for name, value in KNOWN.items() if name in case.body}
                case.body = {name: value for name, value in case.body.items() if name not in OF_THE_CELL}
                case.headers["Idempotency-Key"] = f"made-up-{next(number)}"
                if "name" in case.body:
                    case.body["name"] = f"made-up-{next(number)}"

        def validate_response(self, response: Response, case: Case, **_rest: Any) -> None:
            case.validate_response(response)
            if response.status_code < 300:
                answered.add(case.operation.label)

    run_state_machine_as_test(Chained, settings=IN_A_ROW)
    assert CHAINED[paths] <= answered
