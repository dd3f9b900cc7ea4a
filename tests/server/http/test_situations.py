"""Every situation that the service refuses stands in the table, of the kind that the source raises, and is described."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from core import errors as core_errors
from core.errors import BadInput, HeftError, NoPath, Stopped, slug
from server.http import errors as service_errors
from server.http.errors import Conflict, NotFound
from server.http.problems import KINDS, kinds_by_name, problem_of
from server.http.situations import SITUATIONS, list_kinds, read_words

SOURCE = Path(__file__).parents[3] / "server"
ERRORS = {
    name: kind
    for module in (core_errors, service_errors)
    for name, kind in vars(module).items()
    if isinstance(kind, type) and kind in KINDS and not issubclass(kind, Stopped)
}
OWN = re.compile(r"^(runs|people|jobs|store|request|zone|uploads|serve|imports)-[a-z-]+$")
AT_START = {"BadInput"}
"""What is raised as such where the service starts, its audit log is verified or a process is confined: no request meets it."""


def raised() -> set[tuple[str, str]]:
    """Kinds and codes of the errors that the service's source makes."""
    found: set[tuple[str, str]] = set()
    for file in SOURCE.rglob("*.py"):
        for call in (node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.Call)):
            name = call.func.id if isinstance(call.func, ast.Name) else ""
            if name in ERRORS and name not in AT_START:
                codes = [arg.value for arg in call.args if isinstance(arg, ast.Constant) and isinstance(arg.value, str)]
                found |= {(slug(name), code) for code in codes if OWN.match(code)}
    return found


def test_the_table_has_every_situation_that_the_source_raises() -> None:
    assert sorted((kind, code) for kind, code in raised() if code not in SITUATIONS.get(kind, ())) == []
    assert len(raised()) > 80


def test_the_table_has_kinds_and_codes_that_there_are() -> None:
    assert set(SITUATIONS) <= set(kinds_by_name())
    assert [code for codes in SITUATIONS.values() for code in codes if code not in read_words()] == []


@pytest.mark.parametrize("code", sorted({code for codes in SITUATIONS.values() for code in codes}))
def test_every_situation_is_described_where_its_type_points(nobody: TestClient, code: str) -> None:
    told = nobody.get(f"/problems/{code}").json()
    assert told["kinds"] == list_kinds(code)
    assert told["words"].startswith(f"{code} =")
    assert told["status"] >= 400


def test_a_message_of_the_engine_is_described_too_and_what_there_is_not_is_not(nobody: TestClient) -> None:
    told = nobody.get("/problems/planning-other-axes").json()
    assert (told["kinds"], told["status"], told["parameters"]) == ([], None, ["refusal", "axes"])
    assert nobody.get("/problems/no-such-thing").json()["type"] == "/problems/request-problem-unknown"


PROBLEMS: list[HeftError] = [
    NotFound("runs-unknown", run="1"),
    Conflict("runs-offer-old", age_s=70.5, limit_s=60),
    Conflict("zone-moved-on", zone="operator", moves=2, seen_moves=1),
    NoPath("text", text="No path."),
    BadInput("upload", "text", text="no path"),
]


def described(app: FastAPI, problem: dict[str, Any]) -> list[str]:
    """Names of the schemas of problems that it fits."""
    components = app.openapi()["components"]
    schemas = [each["$ref"] for each in components["schemas"]["Problem"]["oneOf"]]
    fits = [ref for ref in schemas if jsonschema_rs.Draft202012Validator({"$ref": ref, "components": components}).is_valid(problem)]
    return [ref.rpartition("/")[2] for ref in fits]


def test_a_problem_fits_the_one_schema_of_its_situation(app: FastAPI) -> None:
    found = [described(app, problem_of(error).model_dump(mode="json", exclude_none=True)) for error in PROBLEMS]
    assert found == [["RunsUnknownProblem"], ["RunsOfferOldProblem"], ["ZoneMovedOnProblem"], ["EngineProblem"], ["EngineProblem"]]
    wrong = problem_of(Conflict("runs-offer-old", age_s="old", limit_s=60.0)).model_dump(mode="json", exclude_none=True)
    assert described(app, wrong) == []
