"""The service tells how it is: figures for Prometheus, a line of JSON for each request, a description that tools can read."""

from __future__ import annotations

import io
import json
import logging
import re
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from pydantic import BaseModel

from server.http.openapi import operations
from server.http.schemas import Answer, RequestBody
from server.people.roles import Role
from server.telemetry.logs import JsonLines
from server.telemetry.request_context import run_id
from tests.server.made_people import PASSWORD, As


def test_figures_count_requests_by_route_and_not_by_address(signed_in: As) -> None:
    client = signed_in(Role.viewer)
    for name in ("lwr4_bench", "none1", "none2"):
        client.get(f"/api/cells/{name}")
    text = client.get("/metrics").text
    assert 'heft_requests_total{method="GET",route="/api/cells/{cell}",status="200"} 1.0' in text
    assert 'heft_requests_total{method="GET",route="/api/cells/{cell}",status="404"} 2.0' in text
    assert "none1" not in text
    assert "heft_request_seconds_bucket" in text


def test_every_request_is_a_line_of_json_with_its_id(nobody: TestClient, signed_in: As) -> None:
    signed_in(Role.viewer)
    written = io.StringIO()
    lines = logging.StreamHandler(written)
    lines.setFormatter(JsonLines())
    logger = logging.getLogger("heft")
    logger.addHandler(lines)
    logger.setLevel("INFO")
    try:
        answer = nobody.post("/api/session", json={"name": "viewer", "password": PASSWORD})
    finally:
        logger.removeHandler(lines)
        logger.setLevel("NOTSET")
    said = [json.loads(line) for line in written.getvalue().splitlines()]
    request = next(each for each in said if each["message"] == "request")
    assert request["request_id"] == answer.headers["x-request-id"]
    assert (request["route"], request["status"]) == ("/api/session", 200)
    audited = next(each for each in said if each["message"] == "audit")
    assert (audited["audit_action"], audited["request_id"]) == ("session.open", request["request_id"])
    assert PASSWORD not in written.getvalue()


def test_a_line_names_the_run_and_keeps_to_one_line() -> None:
    token = run_id.set("run-7")
    try:
        record = logging.LogRecord("heft", logging.ERROR, "", 0, "two\nlines", None, None)
        line = JsonLines().format(record)
    finally:
        run_id.reset(token)
    assert "\n" not in line
    assert json.loads(line)["run_id"] == "run-7"


def test_answers_carry_what_keeps_browsers_careful(nobody: TestClient) -> None:
    headers = nobody.get("/api/session").headers
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["cache-control"] == "no-store"
    assert headers["x-frame-options"] == "SAMEORIGIN"


def test_operations_have_names_of_their_own_and_answer_with_problems(app: FastAPI) -> None:
    described = app.openapi()
    assert described["openapi"].startswith("3.1")
    found = dict(operations(described))
    names = [operation["operationId"] for operation in found.values()]
    assert len(names) == len(set(names))
    for endpoint, operation in found.items():
        assert operation["responses"]["default"]["content"].keys() == {"application/problem+json"}, endpoint
        refusals = {media for status, answer in operation["responses"].items() if status >= "4" for media in answer["content"]}
        assert refusals == {"application/problem+json"}, endpoint
        assert operation.get("description"), endpoint


def _numbers(schema: Any, path: str = "") -> list[str]:
    """Names of all properties that are physical numbers."""
    if not isinstance(schema, dict):
        return []
    kinds = [schema.get("type"), *(each.get("type") for each in schema.get("anyOf", []))]
    here = [path] if "number" in kinds else []
    return here + [found for name, each in schema.get("properties", {}).items() for found in _numbers(each, name)]


UNITS = r"_(s|ms|m|kg|rad|hz|days|hours|bytes|m_s|n|nm|m_s2|rad_s|rad_s2|kg_m|kg_m2)$"
BARE = {
    "value",
    "std",
    "times_std",
    "limit",
    "progress",
    "inertia_std",
    "size",
    "gap_before",
    "gap_after",
    "closure",
    "probability",
    "none_probability",
    "unknown_probability",
    "lost_share",
}
"""Numbers whose unit another field tells, or that are fractions or multiples."""


def _of_the_service(model: type[BaseModel]) -> set[str]:
    """Names of the models that the service itself defines."""
    return {model.__name__}.union(*(_of_the_service(each) for each in model.__subclasses__()))


def test_every_number_of_the_service_has_its_unit_in_its_name(app: FastAPI) -> None:
    own = _of_the_service(RequestBody) | _of_the_service(Answer)
    schemas = {name: schema for name, schema in app.openapi()["components"]["schemas"].items() if name in own}
    assert len(schemas) > 10
    for name, schema in schemas.items():
        for number in _numbers(schema):
            assert re.search(UNITS, number) or number in BARE, f"{name}.{number}"


@pytest.mark.parametrize("address", ["/redoc", "/api", "/static/../server/app.py"])
def test_nothing_else_is_served(address: str, nobody: TestClient) -> None:
    assert nobody.get(address).status_code == 404
