"""Looks what needs a person: at the runs as soon as something has changed, at the rest now and then."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from datetime import datetime
from typing import Annotated

from sqlalchemy.exc import SQLAlchemyError

from core.words.message import Message
from server.alarms.book import AlarmBook
from server.alarms.kinds import Condition
from server.alarms.of_runs import find_waiting, judge_runs
from server.alarms.of_service import judge_cells, judge_disk, judge_webhooks
from server.alarms.tables import AlarmRow
from server.cells.folder import CellFolder
from server.http.dependencies import depend_on
from server.runs.conductor import Conductor
from server.runs.tables import RunRow
from server.settings import Settings
from server.store.store import Store

log = logging.getLogger("heft.alarms")

LOOK_S = 0.25
"""How often it is looked whether a run has changed."""
RUNS_S = 10.0
"""After so long the runs are looked at although none has changed, and whether the database can be written."""
AGAIN_S = 1.0
"""The same while it cannot."""
SERVICE_S = 30.0
FIRST_S = 3.0
"""Time in which the service that starts has the processor to itself."""
STORE_AWAY = Condition("store_away", "store", Message.of("alarms-store-away"))


class AlarmWatch:
    """Of one service."""

    def __init__(self, settings: Settings, store: Store, cells: CellFolder, conductor: Conductor, now: Callable[[], datetime]) -> None:
        self.book = AlarmBook()
        self._settings, self._store, self._cells, self._conductor, self._now = settings, store, cells, conductor, now
        self._waiting: list[RunRow] = []
        self._of_service: list[Condition] = []
        self._away = False
        self._looking = asyncio.Lock()
        self._task: asyncio.Task[None] | None = None

    async def start(self) -> None:
        """Takes what an earlier service left open, then looks until `close`."""
        await asyncio.to_thread(self._load)
        self._task = asyncio.create_task(self._look_forever())

    def _load(self) -> None:
        with self._store.read() as db:
            self.book.load(db)

    async def close(self) -> None:
        """Between two looks: a thread that still reads the database would keep a connection that nobody closes. What is open stays."""
        if self._task is not None:
            async with self._looking:
                self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def _look_forever(self) -> None:
        loop = asyncio.get_running_loop()
        begin_s, seen, runs_s, service_s = loop.time(), None, -RUNS_S, -SERVICE_S
        while True:
            now_s, runs = loop.time(), self._fingerprint()
            runs_due = runs != seen or now_s - runs_s >= (AGAIN_S if self._away else RUNS_S)
            service_due = now_s - begin_s >= FIRST_S and now_s - service_s >= SERVICE_S
            if runs_due:
                seen, runs_s = runs, now_s
            if service_due:
                service_s = now_s
            await self.look(runs=runs_due, service=service_due)
            await asyncio.sleep(LOOK_S)

    async def look(self, *, runs: bool = True, service: bool = True) -> None:
        """Looks now: at what the database has of the runs, at the service, and in any case at the runs in memory."""
        async with self._looking:
            if runs:
                await self._guard(self._read_runs)
            if service:
                await self._guard(self._read_service)
            self._judge()
            await self._write()

    def _fingerprint(self) -> object:
        active = self._conductor.active
        return self._conductor.queue_changes, [(each.id, each.state) for each in list(active.values())]

    async def _guard(self, read: Callable[[], None]) -> None:
        try:
            await asyncio.to_thread(read)
        except SQLAlchemyError as error:
            if not self._away:
                log.error("the database cannot be used: %s", type(error).__name__)
            self._away = True
        except Exception:  # what cannot be judged now must not silence all other alarms; it is judged again
            log.exception("what needs a person could not be read")

    def _read_runs(self) -> None:
        self._store.check_writable()
        with self._store.read() as db:
            self._waiting = find_waiting(db)
        self._away = False

    def _read_service(self) -> None:
        disk = judge_disk(self._settings.data)
        with self._store.read() as db:
            self._of_service = [*disk, *judge_cells(self._cells, db), *judge_webhooks(db)]

    def _judge(self) -> None:
        """What is in memory is newer than what the database has."""
        active = {each.id: each.row for each in self._conductor.active.values()}
        rows = {row.id: row for row in self._waiting} | active
        away = [STORE_AWAY] if self._away else []
        self.book.update([*judge_runs(rows.values()), *self._of_service, *away], self._now())

    async def _write(self) -> None:
        rows = self.book.take_unwritten()
        if not rows:
            return
        try:
            await asyncio.to_thread(self._put, rows)
        except SQLAlchemyError:
            self.book.give_back(rows)

    def _put(self, rows: list[AlarmRow]) -> None:
        with self._store.write() as db:
            for row in rows:
                db.merge(row)


AlarmsDep = Annotated[AlarmWatch, depend_on("alarms")]
