"""Whatever goes wrong is answered with a problem that says what, where, and what to do."""

from __future__ import annotations

import inspect
import json
import sqlite3
from typing import Any

import pytest
from fastapi.testclient import TestClient
from httpx2 import Response
from sqlalchemy.exc import OperationalError

from core import errors as core_errors
from core.errors import BadCell, HeftError, TooClose, slug
from server.http import errors as service_errors
from server.http.errors import Conflict, TooMany
from server.http.problems import KINDS, headers_of, problem_of
from server.people.roles import Role
from server.service import Service
from tests.server.made_people import As

ERRORS = sorted(
    {
        kind
        for module in (core_errors, service_errors)
        for _, kind in inspect.getmembers(module, inspect.isclass)
        if issubclass(kind, HeftError)
    },
    key=lambda kind: kind.__name__,
)


@pytest.mark.parametrize("kind", ERRORS, ids=lambda kind: kind.__name__)
def test_every_error_of_engine_and_service_has_a_kind_of_problem(kind: type[HeftError]) -> None:
    assert kind in KINDS


def test_every_kind_is_explained_where_its_type_points(nobody: TestClient) -> None:
    for kind, known in KINDS.items():
        told = nobody.get(f"/problems/{slug(kind.__name__)}").json()
        assert (told["title"], told["status"]) == (known.title, known.status)
        assert len(told["meaning"]) > 10


def test_bad_input_names_place_value_and_what_is_expected() -> None:
    problem = problem_of(BadCell("cell.toml: name", "uploads-cell-misnamed", name="line", folder="bench"))
    assert (problem.type, problem.kind, problem.status) == ("/problems/uploads-cell-misnamed", "bad-cell", 422)
    assert problem.detail == 'cell.toml: name: found "line", expected the name of its folder, "bench"'
    parameters = {"where": "cell.toml: name", "name": "line", "folder": "bench"}
    assert problem.parameters == parameters
    assert problem.flaws[0].model_dump() == {
        "where": "cell.toml: name", "found": '"line"', "expected": 'the name of its folder, "bench"',
        "code": "uploads-cell-misnamed", "parameters": parameters,
    }  # fmt: skip


def test_a_stop_carries_value_and_limit() -> None:
    problem = problem_of(TooClose("link 5 is 0.031 m from zone 'operator' (limit 0.050 m)", value=0.031, limit=0.05))
    assert (problem.status, problem.value, problem.limit) == (409, 0.031, 0.05)


def test_a_conflict_names_what_is_allowed_and_haste_when_to_return() -> None:
    assert problem_of(Conflict("runs-recording-open", allowed=["resume", "stop"], run="1")).allowed == ["resume", "stop"]
    assert headers_of(problem_of(TooMany("people-sign-in-blocked", retry_after_s=12.3)))["Retry-After"] == "13"


def _is_problem(answer: Response, status: int, code: str) -> dict[str, Any]:
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"
    found: dict[str, Any] = answer.json()
    assert found["type"] == f"/problems/{code}"
    assert found["status"] == status
    assert found["request_id"] == answer.headers["x-request-id"]
    return found


def test_an_unknown_address_is_a_problem(nobody: TestClient) -> None:
    assert "GET /nowhere" in str(_is_problem(nobody.get("/nowhere"), 404, "request-address-unknown")["detail"])


def test_a_wrong_method_is_a_problem_that_names_the_right_ones(nobody: TestClient) -> None:
    answer = nobody.delete("/health")
    assert _is_problem(answer, 405, "request-method-not-allowed")["allowed"] == ["GET"]
    assert answer.headers["allow"] == "GET"


def test_every_flaw_of_a_body_is_named_and_no_password_is_repeated(nobody: TestClient) -> None:
    answer = nobody.post("/api/session", json={"name": "a b", "password": "s3cret" * 50, "more": 1})
    found = _is_problem(answer, 422, "request-unfit")
    assert {flaw["where"] for flaw in found["flaws"]} == {"body.name", "body.password", "body.more"}
    assert "s3cret" not in answer.text
    without_name = nobody.post("/api/session", json={"password": "s3cret and more"})
    assert [flaw["found"] for flaw in _is_problem(without_name, 422, "request-unfit")["flaws"]] == ["no such key"]


def test_a_body_that_is_no_json_is_a_problem(nobody: TestClient) -> None:
    answer = nobody.post("/api/session", content=b"{", headers={"content-type": "application/json"})
    _is_problem(answer, 400, "request-no-json")


def test_nan_in_a_body_is_refused(signed_in: As) -> None:
    body = json.dumps({"pose": {"xyz_m": [float("nan"), 0, 0]}, "measured_at": "2026-03-01T08:00:00Z"})
    answer = signed_in(Role.operator).put(
        "/api/cells/lwr4_bench/zones/operator", content=body, headers={"content-type": "application/json"}
    )
    assert answer.status_code in (400, 422)
    assert answer.headers["content-type"] == "application/problem+json"


def test_a_body_that_is_too_large_is_a_problem_also_without_a_length(nobody: TestClient) -> None:
    chunks = (b"x" * 100_000 for _ in range(11))
    answer = nobody.post("/api/session", content=chunks, headers={"content-type": "application/json"})
    _is_problem(answer, 413, "request-body-too-large")


def test_a_store_that_does_not_answer_is_a_problem_with_a_time_to_return(
    nobody: TestClient, service: Service, monkeypatch: pytest.MonkeyPatch
) -> None:
    def locked() -> None:
        raise OperationalError("SELECT 1", {}, sqlite3.OperationalError("database is locked"))

    monkeypatch.setattr(service.store, "check", locked)
    answer = nobody.get("/health")
    _is_problem(answer, 503, "store-unavailable")
    assert answer.headers["retry-after"] == "1"


def test_what_nobody_foresaw_is_a_problem_that_tells_nothing(nobody: TestClient, service: Service, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken() -> None:
        raise ZeroDivisionError("secret of the house")

    monkeypatch.setattr(service.store, "check", broken)
    answer = nobody.get("/health")
    assert answer.status_code == 500
    assert answer.headers["content-type"] == "application/problem+json"
    assert "secret" not in answer.text
