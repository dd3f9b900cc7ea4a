"""What routes ask for, as types: the parts of the running service, the time, where a request comes from.

Each part's type stands beside its class: `CallerDep`, `CellsDep`, `ConductorDep`.
"""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Any

from fastapi import Depends, Query, Response
from starlette.requests import HTTPConnection

from server.settings import Settings
from server.store.store import Store
from server.telemetry.metrics import Metrics


def part(name: str) -> Any:
    """A dependency on a part of the running `server.service.Service`, by its name there."""

    def find(connection: HTTPConnection) -> Any:
        return getattr(connection.app.state.service, name)

    return Depends(find)


def read_clock(connection: HTTPConnection) -> datetime:
    """The service's time."""
    now: datetime = connection.app.state.service.now()
    return now


def client_address(connection: HTTPConnection) -> str:
    """Where a request comes from."""
    return "unknown" if connection.client is None else connection.client.host


StoreDep = Annotated[Store, part("store")]
SettingsDep = Annotated[Settings, part("settings")]
MetricsDep = Annotated[Metrics, part("metrics")]
NowDep = Annotated[datetime, Depends(read_clock)]
AddressDep = Annotated[str, Depends(client_address)]
Limit = Annotated[int, Query(ge=1, le=200)]
"""How many of a list are answered."""


def accepted(response: Response, location: str, ask_again_s: int) -> None:
    """The headers of a 202: where what was asked for is, and when it is worth a look."""
    response.headers["Location"] = location
    response.headers["Retry-After"] = str(ask_again_s)
