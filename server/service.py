"""What lives as long as the service does, handed to every route."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import cached_property

from server.alarms.watch import AlarmWatch
from server.cells.drafts import Drafts
from server.cells.folder import CellFolder
from server.cells.tool_outlines import ToolOutlines
from server.cells.uploads import CellChecker
from server.http.console import Console
from server.imports.imports import Imports
from server.jobs import kinds as job_kinds
from server.jobs.jobs import Worker
from server.people.auth import RecentCallers
from server.people.door import Door
from server.runs.conductor import Conductor
from server.runs.lease import ControlRegistry
from server.runs.metrics import RunMetrics
from server.runs.releases import Offers, Releases
from server.runs.webhooks import Deliverer
from server.settings import Settings
from server.store.store import Store
from server.telemetry.metrics import Metrics
from server.telemetry.recent_log import RecentLog
from server.viewer.gallery import Gallery


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
    tool_outlines: ToolOutlines = field(default_factory=ToolOutlines)
    control: ControlRegistry = field(default_factory=ControlRegistry)
    offers: Offers = field(default_factory=Offers)
    console: Console = field(default_factory=Console)
    recent_callers: RecentCallers = field(default_factory=RecentCallers)
    recent_log: RecentLog = field(default_factory=RecentLog)
    later: ThreadPoolExecutor = field(default_factory=lambda: ThreadPoolExecutor(1, "later"))
    """Small writes that nobody waits for."""

    @cached_property
    def started_at(self) -> datetime:
        """When the service started: it asks for this then."""
        return self.now()

    @cached_property
    def drafts(self) -> Drafts:
        """Cells that are being made."""
        return Drafts(self.cells)

    @cached_property
    def imports(self) -> Imports:
        """Logs that are being imported."""
        return Imports(self.settings, self.now)

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
    def trials(self) -> Worker:
        """All blind trials."""
        return Worker(self.store, self.now, job_kinds.trials(self.settings))

    @cached_property
    def deliverer(self) -> Deliverer:
        """What tells the webhooks."""
        return Deliverer(self.store, self.now)

    @cached_property
    def alarms(self) -> AlarmWatch:
        """What needs a person."""
        return AlarmWatch(self.settings, self.store, self.cells, self.conductor, self.now)

    @cached_property
    def gallery(self) -> Gallery:
        """All viewers."""
        return Gallery(self.conductor)

    @cached_property
    def releases(self) -> Releases:
        """What lets a run begin."""
        return Releases(self.conductor, self.control, self.offers, self.now)
