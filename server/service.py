"""What lives as long as the service does, handed to every route."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import cached_property

from server import job_kinds
from server.auth import RecentCallers
from server.cell_folder import CellFolder
from server.cell_uploads import CellChecker
from server.conductor import Conductor
from server.console import Console
from server.control_lease import Control
from server.jobs import Worker
from server.metrics import Metrics
from server.people.door import Door
from server.releases import Offers, Releases
from server.run_metrics import RunMetrics
from server.settings import Settings
from server.store import Store
from server.viewer.gallery import Gallery
from server.webhooks import Deliverer


def utc_now() -> datetime:
    """The time, with its offset."""
    return datetime.now(UTC)


@dataclass(frozen=True)
class Service:
    """Settings and what was opened with them."""

    settings: Settings
    store: Store
    cells: CellFolder
    metrics: Metrics
    checker: CellChecker
    now: Callable[[], datetime] = field(default=utc_now)
    control: Control = field(default_factory=Control)
    offers: Offers = field(default_factory=Offers)
    console: Console = field(default_factory=Console)
    recent_callers: RecentCallers = field(default_factory=RecentCallers)
    later: ThreadPoolExecutor = field(default_factory=lambda: ThreadPoolExecutor(1, "later"))
    """Small writes that nobody waits for."""

    @cached_property
    def door(self) -> Door:
        """What everybody goes through first."""
        return Door(self.settings, self.store, self.recent_callers, self.now, self.later)

    @cached_property
    def run_metrics(self) -> RunMetrics:
        """Figures of the runs."""
        return RunMetrics(self.metrics.registry)

    @cached_property
    def conductor(self) -> Conductor:
        """All runs."""
        return Conductor(self.store, self.cells, self.settings.recordings_folder, self.now, self.run_metrics)

    @cached_property
    def diagnoses(self) -> Worker:
        """All diagnoses."""
        return Worker(self.store, self.now, job_kinds.diagnoses(self.settings, self.cells))

    @cached_property
    def additions(self) -> Worker:
        """What is added to the cells' twins."""
        return Worker(self.store, self.now, job_kinds.additions(self.cells))

    @cached_property
    def trials(self) -> Worker:
        """All blind trials."""
        return Worker(self.store, self.now, job_kinds.trials(self.settings))

    @cached_property
    def deliverer(self) -> Deliverer:
        """What tells the webhooks."""
        return Deliverer(self.store, self.now)

    @cached_property
    def gallery(self) -> Gallery:
        """All viewers."""
        return Gallery(self.conductor)

    @cached_property
    def releases(self) -> Releases:
        """What lets a run begin."""
        return Releases(self.conductor, self.control, self.offers, self.now)
