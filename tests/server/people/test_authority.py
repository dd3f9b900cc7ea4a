"""The table of authority is the whole truth: every endpoint stands in it, and answers each role as it says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from starlette.testclient import WebSocketDenialResponse
from starlette.websockets import WebSocketDisconnect

from server.http.errors import NotAllowed
from server.http.openapi import CSRF_HEADER, operations
from server.people.accounts import sha256
from server.people.authority import ANYBODY, AUTHORITY
from server.people.roles import MACHINE_ROLES, Role
from server.service import Service
from tests.server.made_people import As

GUIDE = Path(__file__).parents[3] / "docs" / "service.md"
SOCKETS = sorted(name for name in AUTHORITY if name.startswith("WS "))
REST = sorted(name for name in AUTHORITY if not name.startswith("WS "))


def test_every_operation_stands_in_the_table(app: FastAPI) -> None:
    described = {name for name, _ in operations(app.openapi())}
    assert described <= AUTHORITY.keys()
    pages = {name for name in REST if "/viewer" in name} | {"GET /", "GET /assets/{path:path}"}
    assert set(REST) - described == {"GET /openapi.json", "GET /asyncapi.json", "GET /docs"} | pages


def test_every_operation_says_who_may_call_it(app: FastAPI) -> None:
    for name, operation in operations(app.openapi()):
        allowed = AUTHORITY[name]
        assert operation["x-roles"] == (["anybody"] if allowed is ANYBODY else sorted(allowed))


def call(client: TestClient, endpoint: str) -> int:
    method, path = endpoint.split(" ")
    return client.request(method, re.sub(r"\{\w+\}", "none", path)).status_code


@pytest.mark.parametrize("role", Role)
def test_each_role_is_let_in_or_refused_as_the_table_says(role: Role, signed_in: As, service: Service) -> None:
    for endpoint in REST:
        allowed = AUTHORITY[endpoint]
        status = call(signed_in(role), endpoint)
        if allowed is ANYBODY or role in allowed:
            assert status not in (401, 403), endpoint
        else:
            assert status == 403, endpoint


@pytest.mark.parametrize("role", sorted(MACHINE_ROLES))
def test_a_machine_is_let_in_or_refused_as_the_table_says(role: Role, with_key: As) -> None:
    client = with_key(role)
    for endpoint in REST:
        allowed = AUTHORITY[endpoint]
        status = call(client, endpoint)
        assert (status == 403) == (allowed is not ANYBODY and role not in allowed) or endpoint == "PUT /api/session/password", endpoint


def test_nobody_gets_in_but_where_anybody_does(nobody: TestClient) -> None:
    for endpoint in REST:
        status = call(nobody, endpoint)
        assert (status == 401) == (AUTHORITY[endpoint] is not ANYBODY), endpoint


def handshake(client: TestClient, endpoint: str, **headers: str) -> int:
    """Status of a refused websocket; 101 where it was let in, whatever it said then."""
    address = re.sub(r"\{\w+\}", "none", endpoint.removeprefix("WS "))
    try:
        with client.websocket_connect(address, headers=headers):
            return 101
    except WebSocketDenialResponse as refusal:
        return refusal.status_code
    except WebSocketDisconnect:
        return 101


@pytest.mark.parametrize("endpoint", SOCKETS)
def test_websockets_are_open_to_whom_the_table_says_from_our_own_pages(endpoint: str, nobody: TestClient, signed_in: As) -> None:
    allowed = AUTHORITY[endpoint]
    assert handshake(nobody, endpoint, Origin="http://testserver") == (101 if allowed is None else 401)
    for role in Role:
        client = signed_in(role)
        let_in = allowed is None or role in allowed
        assert (handshake(client, endpoint, Origin="http://testserver") == 101) == let_in, role
        assert handshake(client, endpoint, Origin="http://evil.example") == 403
        assert handshake(client, endpoint) == (101 if allowed is None else 403)


def test_an_endpoint_that_stands_nowhere_is_refused(app: FastAPI, signed_in: As) -> None:
    app.add_api_route("/api/forgotten", lambda: "open", methods=["GET"])
    answer = signed_in(*Role).get("/api/forgotten")
    assert answer.status_code == 403
    assert "not in the table" in answer.json()["detail"]


def test_machines_neither_release_motion_nor_make_accounts() -> None:
    for endpoint, allowed in AUTHORITY.items():
        if allowed is not None and not endpoint.startswith("GET") and re.search(r"release|accounts|keys|control", endpoint):
            assert not allowed & {Role.mes, Role.viewer}, endpoint
    assert Role.operator not in MACHINE_ROLES
    assert Role.admin not in MACHINE_ROLES


def test_the_guide_shows_the_table() -> None:
    rows = re.findall(r"^\| `([A-Z]+ [^`]+)` \| ([^|]+) \|", GUIDE.read_text(encoding="utf-8"), re.MULTILINE)
    shown = {name: None if who.strip() == "anybody" else frozenset(Role(word.strip()) for word in who.split(",")) for name, who in rows}
    assert shown == AUTHORITY


def test_a_refusal_of_authority_is_written_down(signed_in: As) -> None:
    signed_in(Role.viewer).get("/api/accounts")
    last = signed_in(Role.admin).get("/api/audit").json()[0]
    assert (last["who"], last["action"], last["detail"]["endpoint"]) == ("account:viewer", "authority.refuse", "GET /api/accounts")


@pytest.mark.parametrize("headers", [{}, {CSRF_HEADER: ""}, {CSRF_HEADER: "x" * 32}, {CSRF_HEADER: sha256("x")}])
def test_a_browser_that_changes_something_needs_its_csrf_token(headers: dict[str, str], signed_in: As) -> None:
    client = signed_in(Role.admin)
    client.headers.pop(CSRF_HEADER)
    body = {"name": "line", "role": "mes"}
    assert client.post("/api/keys", json=body, headers=headers).status_code == 403
    assert client.get("/api/keys").json() == []


@pytest.mark.parametrize(
    "headers",
    [{"Origin": "http://evil.example"}, {"Origin": "null"}, {"Sec-Fetch-Site": "cross-site"}, {"Sec-Fetch-Site": "same-site"}],
)
def test_a_foreign_page_changes_nothing_even_with_the_token(headers: dict[str, str], signed_in: As) -> None:
    answer = signed_in(Role.admin).post("/api/keys", json={"name": "line", "role": "mes"}, headers=headers)
    assert answer.status_code == 403


def test_our_own_page_is_let_in(signed_in: As) -> None:
    headers = {"Origin": "http://testserver", "Sec-Fetch-Site": "same-origin"}
    assert signed_in(Role.admin).post("/api/keys", json={"name": "line", "role": "mes"}, headers=headers).status_code == 201


def test_refusals_are_of_the_kinds_that_the_table_means() -> None:
    from server.people.auth import NOBODY, check_authority

    with pytest.raises(NotAllowed, match="nobody may call it"):
        check_authority("GET /api/not/there", NOBODY)
