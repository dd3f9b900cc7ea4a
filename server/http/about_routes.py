"""The service about itself: health, figures, its own description, its problems."""

from __future__ import annotations

from http import HTTPStatus
from typing import Any, Literal

from fastapi import APIRouter, Request, Response
from fastapi.responses import HTMLResponse
from pydantic import Field

from core.version import release_version
from server.http.dependencies import MetricsDep, StoreDep
from server.http.errors import NotFound
from server.http.parameters import ProblemPath
from server.http.problems import ProblemType, kinds_by_name
from server.http.reference import render_reference
from server.http.schemas import Answer
from server.http.situations import list_kinds, read_words
from server.telemetry.metrics import CONTENT_TYPE

router = APIRouter(tags=["service"])

NO_SCRIPTS = {"Content-Security-Policy": "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'none'"}
"""In no sandbox: the cookie has to go along where a link leads."""


class Health(Answer):
    """The service answers, and so does its store."""

    status: Literal["ok"] = Field(description="The service and its store answer.")
    version: str = Field(description="Release of the service.", examples=["0.1.0"])
    safety_rated: Literal[False] = Field(default=False, description="Always false: it is not a safety function.")


class ProblemDescription(Answer):
    """A problem, or a kind of problems."""

    type: str = Field(description="Address of this description, as in a problem's `type`.", examples=["/problems/runs-offer-old"])
    kinds: list[str] = Field(
        description="Of which kind it may be; empty where the engine raises it, whose problems say so themselves.", examples=[["conflict"]]
    )
    title: str = Field(description="What kind of thing it is.", examples=["It does not go with the present state"])
    status: int | None = Field(description="HTTP status of the answer; null where the kind decides.", examples=[409])
    meaning: str = Field(description="What the kind means.", examples=["It does not go with the state that things are in."])
    words: str | None = Field(
        description="In English, as the catalogue has them (projectfluent.org); null for a kind.",
        examples=['runs-unknown = run: there is none called "{ $run }"'],
    )
    parameters: list[str] = Field(description="Names of what the words name.", examples=[["age_s", "limit_s"]])


@router.get("/health")
def read_health(store: StoreDep) -> Health:
    """200 where the service and its store answer, 503 where the store does not."""
    store.check()
    return Health(status="ok", version=release_version())


@router.get("/metrics", response_class=Response, responses={200: {"content": {"text/plain": {}}}})
def read_metrics(metrics: MetricsDep) -> Response:
    """Figures in Prometheus's text format."""
    return Response(metrics.text(), media_type=CONTENT_TYPE)


@router.get("/openapi.json", include_in_schema=False)
def read_openapi(request: Request) -> dict[str, Any]:
    """The OpenAPI 3.1 description."""
    found: dict[str, Any] = request.app.openapi()
    return found


@router.get("/asyncapi.json", include_in_schema=False)
def read_asyncapi(request: Request) -> dict[str, Any]:
    """The AsyncAPI 3 description of the websockets."""
    found: dict[str, Any] = request.app.state.asyncapi()
    return found


@router.get("/docs", include_in_schema=False)
def read_docs(request: Request) -> HTMLResponse:
    """Both descriptions as a page that needs no other address."""
    return HTMLResponse(render_reference(request.app.openapi(), request.app.state.asyncapi()), headers=NO_SCRIPTS)


@router.get("/problems/{code}")
def read_problem(code: ProblemPath) -> ProblemDescription:
    """What a problem's `type` means, and what its `kind` does."""
    known, words = kinds_by_name(), read_words().get(code)
    if words is None and code not in known:
        raise NotFound("request-problem-unknown", problem=code[:80])
    kinds = [code] if words is None else list_kinds(code)
    kind = known[kinds[0]] if kinds else ProblemType(HTTPStatus.INTERNAL_SERVER_ERROR, "A message of the engine")
    return ProblemDescription(
        type=f"/problems/{code}",
        kinds=kinds,
        title=kind.title,
        status=kind.status if kinds else None,
        meaning=kind.meaning,
        words=None if words is None else words.source,
        parameters=[] if words is None else list(words.names),
    )
