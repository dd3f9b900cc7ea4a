"""The service about itself: health, figures, its own description, its kinds of problems."""

from __future__ import annotations

from typing import Any, Literal

from fastapi import APIRouter, Request, Response

from core.version import release_version
from server.http.dependencies import MetricsDep, StoreDep
from server.http.errors import NotFound
from server.http.problems import kinds_by_name
from server.http.schemas import Answer
from server.telemetry.metrics import CONTENT_TYPE

router = APIRouter(tags=["service"])


class Health(Answer):
    """The service answers, and so does its store."""

    status: Literal["ok"]
    version: str
    safety_rated: Literal[False] = False


class ProblemKind(Answer):
    """A kind of problem."""

    type: str
    title: str
    status: int
    meaning: str


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


@router.get("/problems/{kind}")
def read_problem_kind(kind: str) -> ProblemKind:
    """What a problem's `type` means."""
    known = kinds_by_name().get(kind)
    if known is None:
        raise NotFound("kind of problem", kind)
    return ProblemKind(type=f"/problems/{kind}", title=known.title, status=known.status, meaning=known.meaning)
