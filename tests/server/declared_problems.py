"""Holds the problems that are answered against those that the operation declares."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from fastapi import FastAPI
from starlette.requests import HTTPConnection

from server.http.openapi import name_schema, operations
from server.http.problems import ProblemDetails
from server.http.situations import list_kinds

EVERYWHERE = {"request-unforeseen", "request-method-not-allowed", "request-address-unknown", "request-refused", "people-endpoint-closed"}
"""What no operation declares: nobody foresaw it, or there is no operation."""


@cache
def declared(app: FastAPI) -> dict[str, dict[str, str]]:
    """Of each operation the problems by status, as text."""
    return {
        endpoint: {status: str(answer) for status, answer in operation["responses"].items()}
        for endpoint, operation in operations(app.openapi())
    }


def find_undeclared(app: FastAPI, connection: HTTPConnection, found: ProblemDetails) -> Iterator[str]:
    """The problem, if its operation does not declare it."""
    route, code = connection.scope.get("route"), found.type.removeprefix("/problems/")
    endpoint = f"{connection.scope.get('method')} {getattr(route, 'path', '')}"
    if code in EVERYWHERE or endpoint not in declared(app):
        return
    name = name_schema(code) if list_kinds(code) else "EngineProblem"
    if name not in declared(app)[endpoint].get(str(found.status), ""):
        yield f"{endpoint}: {found.status} {code}"
