"""How the service is: for whoever looks after it."""

from __future__ import annotations

import logging
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Response
from sqlalchemy.exc import SQLAlchemyError

from server.cells.folder import CellsDep
from server.http.dependencies import MetricsDep, NowDep, SettingsDep, StoreDep, depend_on
from server.http.downloads import ZIPPED
from server.people import audit
from server.people.auth import CallerDep
from server.support.bundle import Bundle
from server.support.disk import Disk, read_disk
from server.support.versions import Versions, read_versions
from server.telemetry.recent_log import RecentLog

router = APIRouter(prefix="/api/support", tags=["support"])
log = logging.getLogger("heft.support")

StartedDep = Annotated[datetime, depend_on("started_at")]
RecentLogDep = Annotated[RecentLog, depend_on("recent_log")]


@router.get("/versions")
def read_support_versions(store: StoreDep, started_at: StartedDep) -> Versions:
    """What this service is made of, and since when it runs."""
    with store.read() as db:
        return read_versions(db, started_at)


@router.get("/disk")
def read_support_disk(settings: SettingsDep) -> Disk:
    """Room on the disk of the data folder, and what takes it."""
    return read_disk(settings)


@router.get("/bundle", response_class=Response, responses=ZIPPED)
def make_support_bundle(
    settings: SettingsDep,
    store: StoreDep,
    cells: CellsDep,
    metrics: MetricsDep,
    recent_log: RecentLogDep,
    started_at: StartedDep,
    caller: CallerDep,
    now: NowDep,
) -> Response:
    """One zip for an engineer elsewhere, without secrets; takes some seconds.

    Versions, settings, log, health, disk, runs, cells' findings, the latest of the audit log: its `contents.txt` says what is what.
    """
    try:
        with store.write() as db:
            audit.record(db, caller.who, "support.bundle", now=now)
    except SQLAlchemyError:  # the bundle is there to find out why
        log.exception("the making of a support bundle could not be written down")
    made = Bundle(settings, store, cells, metrics, recent_log, started_at).make(now)
    headers = {"Content-Disposition": f'attachment; filename="heft-support-{now:%Y%m%d-%H%M%S}.zip"'}
    return Response(made, media_type="application/zip", headers=headers)
