"""The OpenAPI 3.1 description: FastAPI's, with our problems in place of its errors, and who may call what."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from server.http.problems import MEDIA_TYPE, ProblemDetails
from server.http.situations import NESTED, SITUATIONS, describe_parameter, read_words

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
        operation["responses"]["default"] = PROBLEM
        allowed = authority.get(endpoint, frozenset())
        operation["security"] = [] if allowed is None else [{"browser": []}, {"machine": []}]
        operation["x-roles"] = ["anybody"] if allowed is None else sorted(allowed)
    schemas = found.setdefault("components", {}).setdefault("schemas", {})
    schemas.pop("HTTPValidationError", None)
    schemas.pop("ValidationError", None)
    schemas |= describe_problems()
    found["components"]["securitySchemes"] = SECURITY
    return found


def describe_problems() -> Json:
    """The schema of any problem: one for each situation of the service, with what it names, and one for all of the engine's."""
    base = ProblemDetails.model_json_schema(ref_template=f"{REF}{{model}}")
    kinds: dict[str, list[str]] = {}
    for kind, codes in SITUATIONS.items():
        for code in codes:
            kinds.setdefault(code, []).append(kind)
    own = {"".join(word.title() for word in f"{code}-problem".split("-")): code for code in kinds}
    refs = {f"/problems/{code}": f"{REF}{name}" for name, code in own.items()}
    rooms = "|".join(sorted({code.partition("-")[0] for code in kinds}))
    return {
        **base.pop("$defs"),
        NESTED: {
            "description": "A message that another one names.",
            "type": "object",
            "properties": {"code": {"type": "string"}, "parameters": {"type": "object", "additionalProperties": True}},
            "required": ["code", "parameters"],
        },
        "ProblemDetails": base,
        **{name: _describe_problem(code, kinds[code]) for name, code in own.items()},
        "EngineProblem": {
            "description": "What the engine refuses, whose situations are many; `kind` tells of which kind it is.",
            "allOf": [{"$ref": f"{REF}ProblemDetails"}],
            "properties": {"type": {"type": "string", "pattern": f"^/problems/(?!({rooms})-)"}},
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
            "type": {"const": f"/problems/{code}"},
            "kind": {"enum": kinds},
            **({"parameters": {"type": "object", "properties": parameters, "required": list(parameters)}} if parameters else {}),
        },
        "required": ["type", "kind", "parameters"],
    }


def operations(description: Json) -> Iterator[tuple[str, Json]]:
    """Each operation under its name in the table of authority, "GET /api/cells/{cell}"."""
    for path, methods in description["paths"].items():
        for method, operation in methods.items():
            yield f"{method.upper()} {path}", operation
