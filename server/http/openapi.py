"""The OpenAPI 3.1 description: FastAPI's, with our problems in place of its errors, and who may call what."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from http import HTTPStatus
from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from server.http.operation_problems import ENGINE_REFUSALS, list_problems
from server.http.problem_parameters import NESTED, describe_parameter
from server.http.problems import MEDIA_TYPE, ProblemDetails, kinds_by_name
from server.http.situations import SITUATIONS, list_kinds, read_words

Json = dict[str, Any]
Authority = Mapping[str, frozenset[Any] | None]

COOKIE = "heft_session"
CSRF_HEADER = "X-CSRF-Token"
REF = "#/components/schemas/"
PROBLEM: Json = {
    "description": "A problem (RFC 9457): what, where, the value against the limit, the next step.",
    "content": {MEDIA_TYPE: {"schema": {"$ref": f"{REF}Problem"}}},
}
SECURITY: Json = {
    "browser": {"type": "apiKey", "in": "cookie", "name": COOKIE, "description": f"With {CSRF_HEADER} where something changes."},
    "machine": {"type": "http", "scheme": "bearer", "description": "A key from POST /api/keys."},
}


def _describe_header(name: str, words: str, example: str) -> Json:
    return {"name": name, "in": "header", "required": True, "description": words, "schema": {"type": "string", "examples": [example]}}


WEBHOOKS: Json = {
    "run-ended": {
        "post": {
            "operationId": "run_ended",
            "tags": ["webhooks"],
            "summary": "Run ended",
            "description": "What every webhook is sent when a run has ended: at least once, again until it is answered with 2xx or three "
            "days have passed.",
            "parameters": [
                _describe_header("Heft-Delivery", "Names this delivery; the same when it is tried again.", "019ab1c2ffe0d1c2b3a495"),
                _describe_header("Heft-Timestamp", "When it was sent, s since 1970.", "1772352024"),
                _describe_header("Heft-Signature", "`sha256=` and the HMAC-SHA-256 of `timestamp.body`, hexadecimal.", "sha256=9f86d081"),
            ],
            "requestBody": {"required": True, "content": {"application/json": {"schema": {"$ref": f"{REF}RunPublic"}}}},
            "responses": {"2XX": {"description": "Taken."}, "default": {"description": "Not taken: it is sent again."}},
        }
    }
}


def describe(app: FastAPI, authority: Authority) -> Json:
    """The description of all routes; made once.

    Args:
        authority: who may call what, see `server.people.authority`.
    """
    if app.openapi_schema is None:
        app.openapi_schema = _build_description(app, authority)
    return app.openapi_schema


def _build_description(app: FastAPI, authority: Authority) -> Json:
    found: Json = get_openapi(title=app.title, version=app.version, description=app.description, routes=app.routes)
    for endpoint, operation in operations(found):
        operation["responses"].pop("422", None)
        allowed = authority.get(endpoint, frozenset())
        operation["responses"] |= describe_refusals(endpoint, operation, allowed)
        operation["responses"]["default"] = PROBLEM
        operation["security"] = [] if allowed is None else [{"browser": []}, {"machine": []}]
        operation["x-roles"] = ["anybody"] if allowed is None else sorted(allowed)
    found["webhooks"] = WEBHOOKS
    schemas = found.setdefault("components", {}).setdefault("schemas", {})
    schemas.pop("HTTPValidationError", None)
    schemas.pop("ValidationError", None)
    schemas |= describe_problems()
    found["components"]["securitySchemes"] = SECURITY
    return found


def describe_refusals(endpoint: str, operation: Json, authority: frozenset[Any] | None) -> Json:
    """The answers of an operation that are problems, by status; each with the schemas of the situations that it may tell of."""
    known = kinds_by_name()
    by_status: dict[str, list[str]] = {}
    for code in dict.fromkeys(list_problems(endpoint, operation, authority)):
        status = HTTPStatus.BAD_REQUEST if code == "request-no-json" else known[list_kinds(code)[0]].status
        by_status.setdefault(str(status.value), []).append(name_schema(code))
    for kind in ENGINE_REFUSALS.get(endpoint, ()):
        by_status.setdefault(str(known[kind].status.value), []).append("EngineProblem")
    return {status: _describe_refusal(HTTPStatus(int(status)), list(dict.fromkeys(names))) for status, names in sorted(by_status.items())}


def _describe_refusal(status: HTTPStatus, names: list[str]) -> Json:
    refs = [{"$ref": f"{REF}{name}"} for name in names]
    schema = refs[0] if len(refs) == 1 else {"oneOf": refs}
    return {"description": status.phrase, "content": {MEDIA_TYPE: {"schema": schema}}}


def name_schema(code: str) -> str:
    """Of the schema of a situation's problem, `RunsUnknownProblem`."""
    return "".join(word.title() for word in f"{code}-problem".split("-"))


def describe_problems() -> Json:
    """The schema of any problem: one for each situation of the service, with what it names, and one for all of the engine's."""
    base = ProblemDetails.model_json_schema(ref_template=f"{REF}{{model}}")
    kinds: dict[str, list[str]] = {}
    for kind, codes in SITUATIONS.items():
        for code in codes:
            kinds.setdefault(code, []).append(kind)
    own = {name_schema(code): code for code in kinds}
    refs = {f"/problems/{code}": f"{REF}{name}" for name, code in own.items()}
    rooms = "|".join(sorted({code.partition("-")[0] for code in kinds}))
    return {
        **base.pop("$defs"),
        NESTED: {
            "description": "A message that another one names.",
            "type": "object",
            "properties": {
                "code": {"type": "string", "description": "Which message of the catalogue.", "examples": ["runs-command"]},
                "parameters": {
                    "type": "object",
                    "additionalProperties": True,
                    "description": "What its words name.",
                    "examples": [{"command": "stop"}],
                },
            },
            "required": ["code", "parameters"],
        },
        "ProblemDetails": base,
        **{name: _describe_problem(code, kinds[code]) for name, code in own.items()},
        "EngineProblem": {
            "description": "What the engine refuses, whose situations are many; `kind` tells of which kind it is.",
            "allOf": [{"$ref": f"{REF}ProblemDetails"}],
            "properties": {
                "type": {
                    "type": "string",
                    "pattern": f"^/problems/(?!({rooms})-)",
                    "description": "Address of what describes the situation.",
                    "examples": ["/problems/planning-other-axes"],
                }
            },
        },
        "Problem": {
            "oneOf": [{"$ref": ref} for ref in (*refs.values(), f"{REF}EngineProblem")],
            "discriminator": {"propertyName": "type", "mapping": refs},
        },
    }


def _describe_problem(code: str, kinds: list[str]) -> Json:
    words = read_words()[code]
    parameters = {name: describe_parameter(name, REF) for name in words.names}
    return {
        "description": words.source,
        "allOf": [{"$ref": f"{REF}ProblemDetails"}],
        "type": "object",
        "properties": {
            "type": {"const": f"/problems/{code}", "description": "Address of what describes the situation."},
            "kind": {"enum": kinds, "description": "For programs that know no single situations."},
            **({"parameters": _describe_parameters(parameters)} if parameters else {}),
        },
        "required": ["type", "kind", "parameters"],
    }


def _describe_parameters(parameters: Json) -> Json:
    return {"description": "What the words name.", "type": "object", "properties": parameters, "required": list(parameters)}


def operations(description: Json) -> Iterator[tuple[str, Json]]:
    """Each operation under its name in the table of authority, "GET /api/cells/{cell}"."""
    for path, methods in description["paths"].items():
        for method, operation in methods.items():
            yield f"{method.upper()} {path}", operation
