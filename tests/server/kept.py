"""A store with a clock and nothing that works on it by itself."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from server.settings import Settings
from server.store.store import Store
from tests.server.made_people import Clock


@dataclass
class Kept:
    """What a `Service` has of these names."""

    store: Store
    now: Clock


@contextmanager
def kept(settings: Settings, clock: Clock) -> Iterator[Kept]:
    """Migrated, and closed in the end."""
    settings.data.mkdir(parents=True, exist_ok=True)
    store = Store(settings.store_url)
    store.migrate()
    yield Kept(store, clock)
    store.close()
