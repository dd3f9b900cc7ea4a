"""What routes ask for, as types: the parts of the running service, the time, where a request comes from.

Each part's type stands beside its class: `CallerDep`, `CellsDep`, `ConductorDep`.
"""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Any

from fastapi import Depends
from starlette.requests import HTTPConnection

from server.metrics import Metrics
from server.settings import Settings
from server.store import Store


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
