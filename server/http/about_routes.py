"""The service about itself: health, figures, its own description, its problems."""

from __future__ import annotations

from http import HTTPStatus
from typing import Any, Literal

from fastapi import APIRouter, Request, Response

from core.version import release_version
from server.http.dependencies import MetricsDep, StoreDep
from server.http.errors import NotFound
from server.http.problems import ProblemType, kinds_by_name
from server.http.schemas import Answer
from server.http.situations import list_kinds, read_words
from server.telemetry.metrics import CONTENT_TYPE

router = APIRouter(tags=["service"])


class Health(Answer):
    """The service answers, and so does its store."""

    status: Literal["ok"]
    version: str
    safety_rated: Literal[False] = False


class ProblemDescribed(Answer):
    """A problem, or a kind of problems.

    Args:
        kinds: of which kind it may be; empty where the engine raises it, whose problems say so themselves.
        status: of the answer; null where the kind decides.
        words: in English, as the catalogue has them (projectfluent.org); null for a kind.
        parameters: names of what the words name.
    """

    type: str
    kinds: list[str]
    title: str
    status: int | None
    meaning: str
    words: str | None
    parameters: list[str]


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


@router.get("/problems/{code}")
def read_problem(code: str) -> ProblemDescribed:
    """What a problem's `type` means, and what its `kind` does."""
    known, words = kinds_by_name(), read_words().get(code)
    if words is None and code not in known:
        raise NotFound("request-problem-unknown", problem=code[:80])
    kinds = [code] if words is None else list_kinds(code)
    kind = known[kinds[0]] if kinds else ProblemType(HTTPStatus.INTERNAL_SERVER_ERROR, "A message of the engine")
    return ProblemDescribed(
        type=f"/problems/{code}",
        kinds=kinds,
        title=kind.title,
        status=kind.status if kinds else None,
        meaning=kind.meaning,
        words=None if words is None else words.source,
        parameters=[] if words is None else list(words.names),
    )
