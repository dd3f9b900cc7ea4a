"""Puts the service together: opens what it needs, mounts the routes behind the one door, ends in order."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import AsyncIterator, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from datetime import datetime
from functools import cache

from anyio import to_thread
from fastapi import Depends, FastAPI
from fastapi.routing import APIRoute

from core.version import release_version
from core.words.catalogue import load_catalogue
from server.alarms import routes as alarms_routes
from server.cells import draft_routes
from server.cells import routes as cells_routes
from server.cells.folder import CellFolder
from server.cells.uploads import CellChecker
from server.http import about_routes, console_routes
from server.http.asyncapi import describe_sockets
from server.http.middleware import BodyLimit, Requests
from server.http.openapi import describe
from server.http.problem_answers import answer_with_problems
from server.imports import routes as imports_routes
from server.jobs import diagnosis_routes, motion_routes, timeline_routes, trial_routes, twin_routes
from server.people import account_routes, audit_routes, key_routes, own_session_routes, session_routes
from server.people.authority import AUTHORITY
from server.people.door import let_in
from server.runs import (
    certificate_routes,
    command_routes,
    export_routes,
    file_routes,
    handover_routes,
    lease_routes,
    live_routes,
    now_routes,
    order_routes,
    payload_routes,
    result_routes,
    series_routes,
    watch_routes,
    webhook_routes,
    zone_routes,
)
from server.runs import routes as runs_routes
from server.service import Service, utc_now
from server.settings import Settings
from server.store.store import Store
from server.support import routes as support_routes
from server.telemetry.metrics import Metrics
from server.viewer import routes as viewer_routes
from server.viewer import view_routes

log = logging.getLogger("heft")

CHECKER_AFTER_S = 2.0
"""Time in which the service and its planner have the processor to themselves; an upload that comes sooner begins the checker."""

WAITING = 200
"""Threads that may wait for the database at the same time."""

ROUTES = (
    about_routes,
    session_routes,
    own_session_routes,
    account_routes,
    key_routes,
    audit_routes,
    cells_routes,
    draft_routes,
    zone_routes,
    payload_routes,
    twin_routes,
    lease_routes,
    handover_routes,
    now_routes,
    watch_routes,
    order_routes,
    runs_routes,
    command_routes,
    result_routes,
    series_routes,
    certificate_routes,
    export_routes,
    file_routes,
    live_routes,
    diagnosis_routes,
    imports_routes,
    timeline_routes,
    motion_routes,
    trial_routes,
    webhook_routes,
    support_routes,
    alarms_routes,
    view_routes,
    viewer_routes,
    console_routes,
)
"""In the order of the description, one module a noun; a path goes to the first that fits."""

SOCKETS = (*watch_routes.SOCKETS, *live_routes.SOCKETS, *lease_routes.SOCKETS, *order_routes.SOCKETS, *alarms_routes.SOCKETS)

DESCRIPTION = (
    "Identifies what a robot carries, safely, with people around. Not a safety function. SI units; the unit stands in each field's name. "
    "Every error is application/problem+json (RFC 9457)."
)


def create_app(settings: Settings, *, now: Callable[[], datetime] = utc_now, checker: CellChecker | None = None) -> FastAPI:
    """The service on the given settings; nothing is opened before it starts."""
    service = Service(settings, Store(settings.store_url), CellFolder(settings.cells_folder), Metrics(), checker or CellChecker(), now)

    @asynccontextmanager
    async def running(_app: FastAPI) -> AsyncIterator[None]:
        service.recent_log.start()
        start_service(service)
        make_room_for_waiting()
        work = (service.conductor, service.diagnoses, service.trials, service.deliverer, service.alarms, service.gallery, service.imports)
        for each in work:
            await each.start()
        own = checker is None  # one that was handed in serves others too
        warming = asyncio.create_task(_begin_later(service.checker)) if own else None
        try:
            yield
        finally:
            if warming is not None:
                warming.cancel()
            for each in work:
                await each.close()
            if own:
                service.checker.close()
            service.later.shutdown(cancel_futures=True)
            service.store.close()
            log.info("stopped")
            service.recent_log.end()

    app = FastAPI(
        title="Heft",
        version=release_version(),
        description=DESCRIPTION,
        lifespan=running,
        dependencies=[Depends(let_in)],
        openapi_url=None,  # served by a route that stands in the table of authority, like every other
        docs_url=None,
        redoc_url=None,
        generate_unique_id_function=operation_id,
    )
    app.openapi = lambda: describe(app, AUTHORITY)  # type: ignore[method-assign]  # how FastAPI documents it
    app.state.asyncapi = cache(lambda: describe_sockets(app, AUTHORITY, SOCKETS))
    app.state.service = service
    answer_with_problems(app)
    for routes in ROUTES:
        app.include_router(routes.router)
    app.add_middleware(BodyLimit, settings=settings)
    app.add_middleware(Requests, metrics=service.metrics)
    return app


async def _begin_later(checker: CellChecker) -> None:
    """Loads the words before the event loop needs them, and begins the checker."""
    await asyncio.sleep(CHECKER_AFTER_S)
    await asyncio.to_thread(load_catalogue, "en")
    await asyncio.to_thread(checker.start)


def start_service(service: Service) -> None:
    """Makes the folders, migrates the store, makes the cells ready."""
    log.info("starting", extra={"version": release_version(), "started_at": service.started_at.isoformat()})
    service.settings.data.mkdir(parents=True, exist_ok=True)
    for folder in (service.settings.recordings_folder, service.settings.reports_folder, service.settings.trials_folder):
        folder.mkdir(exist_ok=True)
    service.store.migrate()
    service.cells.prepare()


def make_room_for_waiting() -> None:
    """Requests that wait for a database that hangs are to keep nobody from stopping a robot."""
    to_thread.current_default_thread_limiter().total_tokens = WAITING
    asyncio.get_running_loop().set_default_executor(ThreadPoolExecutor(WAITING, "waiting"))


def operation_id(route: APIRoute) -> str:
    """The function's name: what a generated client calls."""
    return route.name
