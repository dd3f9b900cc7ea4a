"""Who signs in, and the clock by which they do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

import pytest
from fastapi.testclient import TestClient

from server.people import accounts

BOTH_STORES = pytest.mark.parametrize("database_url", ["sqlite", "postgresql"], indirect=True)
"""Runs a test on either database."""

As = Callable[..., TestClient]

PASSWORD = "correct horse battery"
HASH = accounts.hasher.hash(PASSWORD)


@dataclass
class Clock:
    """A clock that goes when it is told to."""

    time: datetime = datetime(2026, 3, 1, 8, 0, tzinfo=UTC)

    def __call__(self) -> datetime:
        return self.time

    def go_on(self, **amount: float) -> None:
        self.time += timedelta(**amount)
