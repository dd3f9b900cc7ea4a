"""What routes ask for, as types: the parts of the running service, the time, where a request comes from.

Each part's type stands beside its class: `CallerDep`, `CellsDep`, `ConductorDep`.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from typing import Annotated, Any

from fastapi import Depends, Response
from starlette.requests import HTTPConnection

from server.settings import Settings
from server.store.store import Store
from server.telemetry.metrics import Metrics


def depend_on(name: str) -> Any:
    """A `Depends` that finds an attribute of the running `server.service.Service` by its name."""

    def find(connection: HTTPConnection) -> Any:
        return getattr(connection.app.state.service, name)

    return Depends(find)


def get_now(connection: HTTPConnection) -> datetime:
    """The service's time."""
    now: datetime = connection.app.state.service.now()
    return now


def get_client_address(connection: HTTPConnection) -> str:
    """Where a request comes from."""
    return "unknown" if connection.client is None else connection.client.host


StoreDep = Annotated[Store, depend_on("store")]
SettingsDep = Annotated[Settings, depend_on("settings")]
LaterDep = Annotated[ThreadPoolExecutor, depend_on("later")]
"""Small writes that nobody waits for."""
MetricsDep = Annotated[Metrics, depend_on("metrics")]
NowDep = Annotated[datetime, Depends(get_now)]
ClientAddressDep = Annotated[str, Depends(get_client_address)]


def set_accepted_headers(response: Response, location: str, retry_after_s: int) -> None:
    """The headers of a 202: where what was asked for is, and when it is worth a look."""
    response.headers["Location"] = location
    response.headers["Retry-After"] = str(retry_after_s)
