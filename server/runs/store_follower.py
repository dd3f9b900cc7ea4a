"""The database follows a run's journal: in order, each entry once, however long the database is locked or away meanwhile."""

from __future__ import annotations

import asyncio
import logging
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress

from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from server.people import audit
from server.runs import ledger as run_ledger
from server.runs.journal import JournalEntry
from server.runs.tables import RunRow
from server.store.store import Store

log = logging.getLogger("heft.runs")

RETRY_S = 0.5
PROBE_S = 1.0
"""Of the looks at a store to which nothing is to be written."""


def keep_entry(db: Session, run: str, entry: JournalEntry) -> RunRow:
    """Writes one entry of a run's journal into the database, once."""
    row = run_ledger.load_run(db, run)
    if row.journaled < entry.number:
        entry.change.apply(row)
        row.journaled = entry.number
        run_ledger.keep(db, row, entry.messages, ended=entry.ended)
        for deed in entry.deeds:
            audit.record_deed(db, deed)
    return row


class StoreFollower:
    """Of one run; belongs to the event loop, and waits for the database in a thread of its own.

    Args:
        clock: monotonic, s.
    """

    def __init__(self, store: Store, run: str, clock: Callable[[], float] = time.monotonic) -> None:
        self._store, self._run, self._clock = store, run, clock
        self._entries: deque[JournalEntry] = deque()
        self._something = asyncio.Event()
        self._caught_up = asyncio.Event()
        self._behind_since_s: float | None = None
        self._writer = ThreadPoolExecutor(1, "run-store")
        self._task = asyncio.create_task(self._follow())

    def add(self, entry: JournalEntry) -> None:
        """Is written when all before it are. Returns at once."""
        self._entries.append(entry)
        self._mark_behind()

    def probe(self) -> None:
        """Asks, although nothing is to be written, whether the database could be."""
        self._mark_behind()

    def _mark_behind(self) -> None:
        self._caught_up.clear()
        self._something.set()
        if self._behind_since_s is None:
            self._behind_since_s = self._clock()

    @property
    def behind_s(self) -> float:
        """For how long the database has not had everything; 0 where it has."""
        return 0.0 if self._behind_since_s is None else self._clock() - self._behind_since_s

    async def caught_up(self, timeout_s: float) -> bool:
        """Whether the database has everything and can be written, waited for at most so long."""
        self.probe()
        with suppress(TimeoutError):
            await asyncio.wait_for(self._caught_up.wait(), timeout_s)
        return self._caught_up.is_set()

    async def close(self) -> None:
        """What is not written yet stays in the journal."""
        self._task.cancel()
        await asyncio.gather(self._task, return_exceptions=True)
        self._writer.shutdown(wait=False)

    async def _follow(self) -> None:
        loop = asyncio.get_running_loop()
        away = False
        while True:
            with suppress(TimeoutError):
                await asyncio.wait_for(self._something.wait(), PROBE_S)
            if not self._something.is_set():
                self._mark_behind()  # a look at a store that nobody writes to
            self._something.clear()
            try:
                if self._entries:
                    await loop.run_in_executor(self._writer, self._keep, self._entries[0])
                    self._entries.popleft()
                else:
                    await loop.run_in_executor(self._writer, self._store.check_writable)
            except SQLAlchemyError as error:
                if not away:
                    log.error("the database does not take what happens to run %s: %s", self._run, type(error).__name__)
                away = True
                await asyncio.sleep(RETRY_S)
                self._something.set()
                continue
            if away:
                log.info("the database takes what happens to run %s again", self._run)
            away = False
            if self._entries:
                self._something.set()
            elif not self._something.is_set():
                self._behind_since_s = None
                self._caught_up.set()

    def _keep(self, entry: JournalEntry) -> None:
        with self._store.write() as db:
            keep_entry(db, self._run, entry)
